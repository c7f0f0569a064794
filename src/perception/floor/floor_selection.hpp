#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "perception/planes/plane_extraction.hpp"
#include "polygonal_perception/perception/floor/floor_detector.hpp"

namespace polygonal_perception::perception {

/// A plane of the frame that may be the floor, with what speaks for it and against it.
struct FloorCandidate
{
  PlaneFit::Result fit;
  std::uint32_t size = 0;       // its samples
  int index = 0;                // among the planes of the frame
  double tilt = 0.0;            // [rad] from the up vector
  double begin = 0.0;           // [m] along the plane from under the camera to its nearest samples
  double middle = 0.0;          // [m] the same to the middle of its samples
  double scatter = 0.0;         // samples below it that are of no level plane
  bool too_low = false;         // the camera cannot be so high above it: it only helps to tell what a step is
  bool continues = false;       // it is where the last floor was
  bool is_other_plane = false;  // it is where another plane was seen with the last floor
  bool is_step = false;
  bool leads_down = false;  // there are steps below it that are none of the robot's floor
  bool refused = false;     // a closer look found that it is no floor
  double score = 0.0;       // [nat] the sum of what is known of it alone
};

/// Whether a plane is far from what tf calls level.
bool contradictsTf(const geometry::Plane& plane, const FloorSelectionParameters& parameters,
                   const FloorPrior& prior);

/// Says which of a frame's planes is the floor (section III-D).
///
/// Algorithm 2 takes the lowest along the up vector, and a larger one in its place by a factor. Here each plane has a
/// score, a sum of terms (FloorSelectionParameters names and explains them), and from the best one goes down, from
/// plane to plane, as long as the samples seen below speak for it: what has another level plane below it is a table, a
/// dais or a pallet.
class FloorSelection
{
public:
  /// Rates the planes of a frame anew.
  void rate(const PlaneExtraction& extraction, const FloorSelectionParameters& parameters,
            const FloorPrior& prior);

  /// The floor, as far as the samples tell, among the candidates that are not refused; nullptr where none has the
  /// least score.
  FloorCandidate* best(const FloorSelectionParameters& parameters);

  /// Where the other level planes lie about the floor.
  PlaneOffsets others(const geometry::Plane& floor, const FloorSelectionParameters& parameters) const;

  /// Whether a plane of the frame is level and at a height at which a floor can be.
  bool isCandidate(std::size_t plane) const { return candidate_of_[plane] >= 0; }
  const std::vector<FloorCandidate>& candidates() const { return candidates_; }

private:
  void collect(const PlaneExtraction& extraction, const FloorSelectionParameters& parameters,
               const FloorPrior& prior);
  void compare(const PlaneExtraction& extraction, const FloorSelectionParameters& parameters);
  /// [nat] What speaks for going from one candidate to another.
  double evidence(std::size_t from, std::size_t to, const FloorSelectionParameters& parameters) const;

  std::size_t samples_ = 0;  // of the frame
  HeightBounds bounds_;      // of the camera
  std::vector<FloorCandidate> candidates_;
  std::vector<double> below_;      // of each candidate, how many samples of each other one lie below it
  std::vector<int> candidate_of_;  // of each plane, or -1
  std::vector<std::uint8_t> is_parallel_;  // of each plane, to the candidate that is compared
  std::vector<double> distances_;
};

}  // namespace polygonal_perception::perception

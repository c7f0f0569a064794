#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "perception/floor/floor_choice.hpp"
#include "perception/floor/noisy_points.hpp"
#include "perception/floor/segmentation.hpp"
#include "polygonal_perception/perception/floor/floor_detector.hpp"

namespace polygonal_perception::perception {

/// The band in which a point counts as one of a plane.
NoisyPoints::Band bandOf(const FloorDetector::Parameters& parameters);

/// Whether the camera can be that high.
bool isAtCameraHeight(const geometry::Plane& plane, const FloorDetector::Parameters& parameters);

/// Whether hardly a point lies below a plane, or none that could be of a floor instead.
bool isLowest(const geometry::Plane& plane, const NoisyPoints::InlierCount& counts,
              const FloorDetector::Parameters& parameters);

/// Finds the level planes among the samples of a frame and says which is most likely the floor (sections
/// III-B to III-D).
///
/// It departs from algorithm 2 where that goes wrong. A plane is not the floor for being reached first along
/// the up vector, which may be 40 degrees off, but because hardly a sample lies below it; segments are not
/// merged by the distance of their averages but by holding every sample against the plane, with the noise
/// that it has; and what was seen with the last floor decides where a frame alone could not: whether a lower
/// plane is the floor under a table or a storey below.
class FloorCandidates
{
public:
  /// Collects the candidates of a frame anew. What is given must outlive the calls that follow.
  void collect(const SampleGrid& grid, const FloorDetector::Parameters& parameters, const FloorPrior& prior);

  /// The most likely floor among those that are not refused yet, or nullptr.
  FloorCandidate* best(const FloorPrior& prior);

  bool empty() const { return candidates_.empty(); }

  /// Where the other level planes lie about the floor.
  PlaneOffsets others(const geometry::Plane& floor) const;

  /// What became of each sample of the grid.
  /// @return how many belong to the floor
  std::uint32_t label(const std::optional<geometry::Plane>& floor,
                      const FloorDetector::Parameters& parameters, std::vector<SampleLabel>& labels);

private:
  void takeSamples(const SampleGrid& grid);
  std::optional<geometry::Plane> planeOf(const SampleGrid& grid, const Segmentation::Segment& segment,
                                         const FloorPrior& prior) const;
  bool isCovered(const SampleGrid& grid, const Segmentation::Segment& segment) const;
  void examine(const geometry::Plane& hypothesis, const FloorDetector::Parameters& parameters,
               const FloorPrior& prior);

  Segmentation segmentation_;
  NoisyPoints samples_;                      // those with a point
  std::vector<std::uint32_t> sample_index_;  // their indices in the grid
  std::vector<Eigen::Vector3f> normals_;     // their normals, zero where not upright
  std::vector<std::uint32_t> by_size_;
  std::vector<std::uint32_t> picked_;
  std::vector<FloorCandidate> candidates_;
  /// Level planes lower than the camera can stand on, and steps above them.
  std::vector<FloorCandidate> too_low_;
  double lowest_possible_ = 0.0;  // [m] below which a floor may have points under it
};

}  // namespace polygonal_perception::perception

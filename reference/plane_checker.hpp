#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "polygonal_perception/cameras/simulation/simulated_camera.hpp"
#include "polygonal_perception/perception/segmentation/segmented_planes.hpp"

namespace polygonal_perception::reference {

/// The planes contract, counted over rendered frames.
///
/// A plane that was found is drawn into the image by its boundary; it is of the true plane that fills 80 % of what is not
/// covered by something nearer.
struct PlaneCounts
{
  int frames = 0;
  int listed = 0;     // planes that were found
  int true_ones = 0;  // that fill at least 3 % of the image
  int found = 0;      // of those: covered to 80 % but for a sample's stride, within 1 degree and 1 cm
  int uncovered = 0;
  int off = 0;       // covered, but not within that
  int split = 0;     // more than one plane on one connected piece
  int invented = 0;  // found planes over 1 % of the image that are of no true one
  int pairs = 0;     // true planes that were found in two frames that follow one another
  int kept = 0;      // of those: with the same id
  std::vector<double> degrees;
  std::vector<double> millimetres;
  std::vector<std::string> faults;  // a line for each that is uncovered, off, split or invented

  void add(const PlaneCounts& other);
};

class PlaneChecker
{
public:
  /// @param samples_x,samples_y  of the grid by which the planes were found
  PlaneChecker(const simulation::SimulatedCamera& camera, int samples_x, int samples_y);

  /// Counts a frame; one after the other, as a sequence.
  void add(const simulation::SimulatedFrame& frame, const perception::SegmentedPlanes& planes);

  const PlaneCounts& counts() const { return counts_; }

private:
  struct True;
  struct Found;

  Found look(const simulation::SimulatedFrame& frame, const perception::SegmentedPlanes& planes,
             const perception::SegmentedPlane& plane) const;
  std::map<std::uint16_t, std::vector<Found>> findOwners(const simulation::SimulatedFrame& frame,
                                                         const perception::SegmentedPlanes& planes);
  std::string besides(const simulation::SimulatedFrame& frame, const perception::SegmentedPlanes& planes,
                      const Found& found) const;
  double sigmaAt(double depth) const;
  bool isCovered(const simulation::SimulatedFrame& frame, const True& truth, const std::vector<Found>& found);
  void judgeFit(const simulation::SimulatedFrame& frame, const True& truth,
                const perception::SegmentedPlane& plane);
  void countSplits(const simulation::SimulatedFrame& frame, const True& truth,
                   const std::vector<Found>& found);
  geometry::Plane truePlane(const simulation::SimulatedFrame& frame, std::uint16_t number) const;
  void fault(const simulation::SimulatedFrame& frame, const std::string& text);

  const simulation::SimulatedCamera& camera_;
  int stride_x_;
  int stride_y_;
  PlaneCounts counts_;
  std::map<std::uint16_t, std::uint32_t> last_ids_;  // of the true planes in the last frame
};

}  // namespace polygonal_perception::reference

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "perception/planes/plane_segment.hpp"
#include "perception/planes/region_growing.hpp"
#include "perception/planes/segment_joining.hpp"

namespace polygonal_perception::perception {

/// A plane of a frame.
struct ExtractedPlane
{
  PlaneFit::Result fit;     // its normal is towards the camera
  std::uint32_t first = 0;  // its samples are members()[first .. first + size), indices into the grid
  std::uint32_t size = 0;
};

/// Finds all planes among the samples of a frame, without an up vector (sections III-B, last lines, and III-C).
class PlaneExtraction
{
public:
  /// @param known  a plane that was there before and is looked for, however few samples show it
  void extract(const SampleGrid& grid, const PlaneExtractionParameters& parameters,
               const std::optional<geometry::Plane>& known);

  const std::vector<ExtractedPlane>& planes() const { return planes_; }
  const std::vector<std::uint32_t>& members() const { return members_; }
  /// The plane of each sample of the grid, or PlaneSegments::kNone.
  const std::vector<int>& planeOf() const { return segments_.of_sample; }
  const NoisySamples& samples() const { return samples_; }

  /// Calls visit(sample) for each sample of a plane.
  template <class Visit>
  void forEachMember(const ExtractedPlane& plane, Visit&& visit) const
  {
    for (std::uint32_t m = plane.first; m < plane.first + plane.size; ++m) visit(samples_[members_[m]]);
  }

private:
  void assignSamples();
  void refit();
  void listMembers();

  PlaneExtractionParameters parameters_;  // of the last frame
  RegionGrowing growing_;
  SegmentContacts contacts_;
  SegmentJoining joining_;
  NoisySamples samples_;
  PlaneSegments segments_;
  std::vector<ReferencePlane> references_;
  std::vector<int> number_;
  std::vector<ExtractedPlane> planes_;
  std::vector<std::uint32_t> members_;
};

}  // namespace polygonal_perception::perception

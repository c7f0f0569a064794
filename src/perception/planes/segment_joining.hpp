#pragma once

#include <cstddef>
#include <vector>

#include "perception/planes/plane_segment.hpp"
#include "perception/planes/segment_contacts.hpp"

namespace polygonal_perception::perception {

/// Makes one segment of those that are pieces of one plane (section III-D, algorithm 2, which joins by the distance
/// of averages; here by what the noise leaves certain of each piece).
class SegmentJoining
{
public:
  /// Joins the pieces of a frame. They need not touch: a floor on both sides of a chair's leg. Two parallel planes a step
  /// apart stay two, however small the step, as long as both are known better than it is high.
  void join(const PlaneExtractionParameters& parameters, SegmentContacts& contacts, PlaneSegments& segments);

  /// Whether a plane is one of the segments' already.
  static bool has(const PlaneSegments& segments, const geometry::Plane& plane,
                  const PlaneExtractionParameters& parameters);

private:
  void apply(PlaneSegments& segments);

  std::vector<std::size_t> by_size_;
  std::vector<int> into_;  // which segment each one joins, itself where it stays
  std::vector<int> number_;
};

}  // namespace polygonal_perception::perception

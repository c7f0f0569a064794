#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace polygonal_perception::geometry {

/// Calls visit(i, j) once for each pair of boxes that share a point, in either order, until it returns true:
/// sweep and prune along x.
///
/// @return whether a call returned true
template <class Visit>
bool anyOverlappingPair(const std::vector<Eigen::AlignedBox2d>& boxes, Visit&& visit)
{
  std::vector<std::uint32_t> order(boxes.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
            [&boxes](std::uint32_t i, std::uint32_t j) { return boxes[i].min().x() < boxes[j].min().x(); });
  for (auto first = order.begin(); first != order.end(); ++first) {
    const Eigen::AlignedBox2d& box = boxes[*first];
    for (auto second = first + 1; second != order.end(); ++second) {
      const Eigen::AlignedBox2d& other = boxes[*second];
      if (other.min().x() > box.max().x()) break;
      if (other.min().y() > box.max().y() || other.max().y() < box.min().y()) continue;
      if (visit(*first, *second)) return true;
    }
  }
  return false;
}

}  // namespace polygonal_perception::geometry

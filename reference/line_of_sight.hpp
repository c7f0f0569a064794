#pragma once

#include <Eigen/Core>
#include <optional>

#include "polygonal_perception/geometry/ring_view.hpp"

namespace polygonal_perception::reference {

/// Where a segment first comes to an inner point of an obstacle at one of its rings, whose obstacle lies to the left of its
/// edges. It may touch the obstacle and run along it. Signs are exact.
///
/// @param from, to  [m] not inside the obstacle
/// @return as a share of the segment; nothing where it does not
std::optional<double> blockedAt(const geometry::RingView& ring, const Eigen::Vector2d& from,
                                const Eigen::Vector2d& to);

}  // namespace polygonal_perception::reference

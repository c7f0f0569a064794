#pragma once

#include <Eigen/Core>

namespace polygonal_perception::planning {

/// Where the line through a and b meets the segment from c to d, which it crosses.
Eigen::Vector2d lineCrossing(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                             const Eigen::Vector2d& d);

/// The length of the shortest way from a root through the interval from `right` to `left` to a goal, whatever lies between:
/// the estimate of Polyanya (section 4). A goal on the root's side of the interval counts as if it lay behind it, as in a
/// mirror. All in metres.
double lengthThrough(const Eigen::Vector2d& right, const Eigen::Vector2d& left, const Eigen::Vector2d& root,
                     const Eigen::Vector2d& goal);

}  // namespace polygonal_perception::planning

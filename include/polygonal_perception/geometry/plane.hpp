#pragma once

#include <Eigen/Core>

namespace polygonal_perception::geometry {

/// An oriented plane, normal . p + distance = 0. As a floor its normal points up and its distance is the
/// height of the origin of the points' frame above it.
struct Plane
{
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit length
  double distance = 0.0;                              ///< [m]

  /// Signed height of p above the plane [m].
  double height(const Eigen::Vector3d& p) const { return normal.dot(p) + distance; }
};

}  // namespace polygonal_perception::geometry

#pragma once

#include <Eigen/Geometry>
#include <cmath>

namespace polygonal_perception::geometry {

constexpr double kPi = 3.14159265358979323846;

/// The angle between two vectors of any length but 0 [rad], exact for small ones, too.
inline double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace polygonal_perception::geometry

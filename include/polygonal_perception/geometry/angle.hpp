#pragma once

#include <Eigen/Geometry>
#include <cmath>

namespace polygonal_perception::geometry {

constexpr double kPi = 3.14159265358979323846;
constexpr double kTwoPi = 2.0 * kPi;
constexpr double kDegree = kPi / 180.0;  ///< [rad]

/// The angle between two vectors of any length but 0 [rad], exact for small ones, too.
inline double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace polygonal_perception::geometry

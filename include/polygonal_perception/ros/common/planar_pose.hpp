#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Quaternion.h>

#include <cmath>

/// What a message's pose says of a place on the floor.
namespace polygonal_perception::ros_common {

/// Whether x and y are numbers within 1000 km of the origin: farther away a double has no millimetres to spare.
inline bool isPlace(const geometry_msgs::Point& p)
{
  constexpr double kFarthest = 1e6;  // [m]
  return std::abs(p.x) < kFarthest && std::abs(p.y) < kFarthest;
}

/// Whether a quaternion is one of length 1, but for rounding.
inline bool isRotation(const geometry_msgs::Quaternion& q)
{
  return std::abs(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w - 1.0) < 0.01;
}

/// [rad] Of any rotation what turns about z.
inline double yawOf(const geometry_msgs::Quaternion& q)
{
  return std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
}

}  // namespace polygonal_perception::ros_common

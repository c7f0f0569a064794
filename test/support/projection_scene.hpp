#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "polygonal_perception/perception/floor/floor_frame.hpp"

namespace polygonal_perception::test {

/// A camera 0.8 m above the floor that looks 20 degrees down, in an optical frame.
inline Eigen::Isometry3d tiltedCamera(double height = 0.8)
{
  const double pitch = 0.35;
  return perception::floorFrame(
      geometry::Plane{Eigen::Vector3d(0.0, -std::cos(pitch), -std::sin(pitch)), height},
      perception::ViewAxes{});
}

/// A point of a cloud as drivers send it.
struct PackedPoint
{
  float x, y, z, padding;
};

}  // namespace polygonal_perception::test

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "polygonal_perception/geometry/plane.hpp"

namespace polygonal_perception::perception {

/// How a plane lies, as far as up is known. The values are those of Plane.msg.
enum class PlaneKind : std::uint8_t
{
  kUnknown = 0,     ///< nobody knows where up is
  kFloor = 1,       ///< the floor that the robot stands on
  kHorizontal = 2,  ///< level: table tops, platforms, ceilings
  kVertical = 3,    ///< upright: walls, doors, fronts of furniture
  kSloped = 4       ///< neither: ramps, roofs, open lids
};

/// A connected piece of a plane that was seen in a frame. Pieces of one plane that do not touch, such as a wall on both
/// sides of a door, have the same fit and an id each.
struct SegmentedPlane
{
  std::uint32_t id = 0;  ///< kept from frame to frame while pieces overlap in the image; from 1
  PlaneKind kind = PlaneKind::kUnknown;
  geometry::Plane plane;   ///< in the input's frame; the normal is towards the sensor
  double rms_error = 0.0;  ///< [m] of the fitted points
  /// Of the normal's three components [1] and the distance [m].
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
  std::uint32_t sample_count = 0;  ///< samples in the piece
  std::uint32_t first_vertex =
      0;  ///< its boundary is SegmentedPlanes::vertices[first_vertex .. + vertex_count)
  std::uint32_t vertex_count = 0;
};

/// All planes of a frame, the largest first.
struct SegmentedPlanes
{
  std::vector<SegmentedPlane> planes;
  /// [m] in the input's frame: the boundaries, each a ring that is not convex in general, on its plane and
  /// counter-clockwise as the sensor sees it. What lies before a plane leaves no hole in its boundary.
  std::vector<Eigen::Vector3f> vertices;

  void clear()
  {
    planes.clear();
    vertices.clear();
  }
};

}  // namespace polygonal_perception::perception

#pragma once

#include <geometry_msgs/Polygon.h>
#include <polygonal_perception/FloorPlane.h>
#include <polygonal_perception/ObstaclePolygon.h>
#include <polygonal_perception/PolygonArray.h>
#include <std_msgs/Header.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/polygon_set.hpp"
#include "polygonal_perception/ros/common/expected.hpp"

/// Polygons as messages and back. Messages hold float32, polygon sets double.
namespace polygonal_perception::ros_common {

/// What a PolygonArray says beside its polygons.
struct PolygonContext
{
  std_msgs::Header header;                             ///< stamp of the input, output frame
  std::uint8_t floor_status = FloorPlane::NOT_FOUND;   ///< as FloorPlane.status
  double inflation_radius = 0.0;                       ///< [m] by which the obstacles have grown
  Eigen::AlignedBox2d extent = Eigen::AlignedBox2d();  ///< [m] what was looked at, in the polygons' frame
};

/// Makes a new message, which readers in the same process may share. With NOT_FOUND it has neither polygons
/// nor an extent.
///
/// @param polygons     each boundary counter-clockwise and followed by its holes, clockwise
/// @param output_pose  of the polygons' and the extent's frame in the output frame
POLYGONAL_PERCEPTION_EXPORT PolygonArrayPtr toPolygonArray(const PolygonContext& context,
                                                           const geometry::PolygonSet& polygons,
                                                           const Eigen::Isometry2d& output_pose);

/// @param pose  of the ring's frame in the polygon's
/// @return the ring's vertices in their order, rounded to float32, z = 0
POLYGONAL_PERCEPTION_EXPORT geometry_msgs::Polygon toPolygon(
    const geometry::RingView& ring, const Eigen::Isometry2d& pose = Eigen::Isometry2d::Identity());

/// @return the polygon's points in their order, unchecked, without their z; for a PolygonArray's extent
POLYGONAL_PERCEPTION_EXPORT std::vector<Eigen::Vector2d> toVertices(const geometry_msgs::Polygon& polygon);

/// Reads a message that anybody may have made.
///
/// @return the boundary, followed by the holes; an error that names the ring ("hole 1") where it has fewer
///         than 3 vertices or a coordinate that is not finite. Whether rings are simple is not looked at:
///         geometry::findDefect does.
POLYGONAL_PERCEPTION_EXPORT Expected<geometry::PolygonSet> toPolygonSet(const ObstaclePolygon& polygon);

/// The same of all polygons of an array, in its frame. The error names the polygon, too.
POLYGONAL_PERCEPTION_EXPORT Expected<geometry::PolygonSet> toPolygonSet(const PolygonArray& array);

}  // namespace polygonal_perception::ros_common

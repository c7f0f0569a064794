#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Geometry>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/polygon_set.hpp"

namespace polygonal_perception::ros_common {

/// Of outlines; the filled area is paler.
struct PolygonColor
{
  float red, green, blue;
};
inline constexpr PolygonColor kFrameColor{0.9F, 0.3F, 0.1F};  ///< polygons of a frame
inline constexpr PolygonColor kMapColor{0.6F, 0.2F, 0.8F};    ///< polygons of a map

/// The outlines and the filled area of the polygons. An empty set deletes the markers of the frame before.
///
/// @param header       stamp of the input, output frame
/// @param output_pose  of the polygons' frame in the output frame
POLYGONAL_PERCEPTION_EXPORT void appendPolygonMarkers(const std_msgs::Header& header,
                                                      const geometry::PolygonSet& polygons,
                                                      const Eigen::Isometry2d& output_pose,
                                                      const PolygonColor& in,
                                                      visualization_msgs::MarkerArray& markers);

}  // namespace polygonal_perception::ros_common

#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Geometry>
#include <vector>

#include "polygonal_perception/geometry/polygon_set.hpp"
#include "polygonal_perception/perception/floor/floor_tracker.hpp"

namespace polygonal_perception::ros_perception {

/// The outlines and the filled area of the polygons. An empty set deletes the markers of the frame before.
///
/// @param header       stamp of the input, output frame
/// @param output_pose  of the floor frame in the output frame
void appendPolygonMarkers(const std_msgs::Header& header, const geometry::PolygonSet& polygons,
                          const Eigen::Isometry2d& output_pose, visualization_msgs::MarkerArray& markers);

/// The normal of the floor under the input frame's origin and the hull of the floor samples (figure 3 of the
/// paper). Without a floor they delete those of the frame before.
///
/// @param header  stamp and frame of the input
void appendFloorMarkers(const std_msgs::Header& header, const perception::FloorState& floor,
                        const std::vector<Eigen::Vector3f>& hull, visualization_msgs::MarkerArray& markers);

}  // namespace polygonal_perception::ros_perception

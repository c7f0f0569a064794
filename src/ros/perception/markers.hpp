#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Geometry>
#include <vector>

#include "polygonal_perception/perception/floor/floor_tracker.hpp"

namespace polygonal_perception::ros_perception {

/// The normal of the floor under the input frame's origin and the hull of the floor samples (figure 3 of the
/// paper). Without a floor they delete those of the frame before.
///
/// @param header  stamp and frame of the input
void appendFloorMarkers(const std_msgs::Header& header, const perception::FloorState& floor,
                        const std::vector<Eigen::Vector3f>& hull, visualization_msgs::MarkerArray& markers);

}  // namespace polygonal_perception::ros_perception

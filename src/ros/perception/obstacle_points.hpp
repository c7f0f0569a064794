#pragma once

#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Header.h>

#include <Eigen/Geometry>
#include <vector>

namespace polygonal_perception::ros_perception {

/// The points that stand in the grid (Projection::collect) as a cloud.
///
/// @param header       stamp of the input, output frame
/// @param standing     in the floor frame [m]
/// @param output_pose  of the floor frame in the output frame
/// @return x, y in the output frame and z the height above the floor, float32 each; one row
sensor_msgs::PointCloud2Ptr toObstaclePoints(const std_msgs::Header& header,
                                             const std::vector<Eigen::Vector3f>& standing,
                                             const Eigen::Isometry2d& output_pose);

}  // namespace polygonal_perception::ros_perception

#include <pluginlib/class_list_macros.hpp>

#include "polygonal_perception/cameras/simulation_ros/simulated_camera_node.hpp"
#include "polygonal_perception/ros/common/nodelet_of.hpp"

namespace polygonal_perception::simulation_ros {

using SimulatedCameraNodelet = ros_common::NodeletOf<SimulatedCameraNode>;

}  // namespace polygonal_perception::simulation_ros

PLUGINLIB_EXPORT_CLASS(polygonal_perception::simulation_ros::SimulatedCameraNodelet, nodelet::Nodelet)

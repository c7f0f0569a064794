#include <pluginlib/class_list_macros.hpp>

#include "polygonal_perception/cameras/openni2_ros/openni2_camera_node.hpp"
#include "polygonal_perception/ros/common/nodelet_of.hpp"

namespace polygonal_perception::openni2_ros {

using OpenNI2Camera = ros_common::NodeletOf<OpenNI2CameraNode>;

}  // namespace polygonal_perception::openni2_ros

PLUGINLIB_EXPORT_CLASS(polygonal_perception::openni2_ros::OpenNI2Camera, nodelet::Nodelet)

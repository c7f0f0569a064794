#include <pluginlib/class_list_macros.hpp>

#include "polygonal_perception/ros/common/nodelet_of.hpp"
#include "polygonal_perception/ros/driving/dynamic_window_node.hpp"

namespace polygonal_perception::ros_driving {

using DynamicWindow = ros_common::NodeletOf<DynamicWindowNode>;

}  // namespace polygonal_perception::ros_driving

PLUGINLIB_EXPORT_CLASS(polygonal_perception::ros_driving::DynamicWindow, nodelet::Nodelet)

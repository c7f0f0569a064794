#include <pluginlib/class_list_macros.hpp>

#include "polygonal_perception/ros/common/nodelet_of.hpp"
#include "polygonal_perception/ros/perception/perception_node.hpp"

namespace polygonal_perception::ros_perception {

using PolygonalPerception = ros_common::NodeletOf<PerceptionNode>;

}  // namespace polygonal_perception::ros_perception

PLUGINLIB_EXPORT_CLASS(polygonal_perception::ros_perception::PolygonalPerception, nodelet::Nodelet)

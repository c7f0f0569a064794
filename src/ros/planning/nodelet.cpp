#include <pluginlib/class_list_macros.hpp>

#include "polygonal_perception/ros/common/nodelet_of.hpp"
#include "polygonal_perception/ros/planning/shortest_path_node.hpp"

namespace polygonal_perception::ros_planning {

using ShortestPath = ros_common::NodeletOf<ShortestPathNode>;

}  // namespace polygonal_perception::ros_planning

PLUGINLIB_EXPORT_CLASS(polygonal_perception::ros_planning::ShortestPath, nodelet::Nodelet)

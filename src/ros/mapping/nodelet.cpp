#include <pluginlib/class_list_macros.hpp>

#include "polygonal_perception/ros/common/nodelet_of.hpp"
#include "polygonal_perception/ros/mapping/polygon_map_node.hpp"

namespace polygonal_perception::ros_mapping {

using PolygonMap = ros_common::NodeletOf<PolygonMapNode>;

}  // namespace polygonal_perception::ros_mapping

PLUGINLIB_EXPORT_CLASS(polygonal_perception::ros_mapping::PolygonMap, nodelet::Nodelet)

#include "polygonal_perception/ros/common/nodelet_of.hpp"
#include "polygonal_perception/ros/mapping/polygon_map_node.hpp"

int main(int argc, char** argv)
{
  using namespace polygonal_perception;
  return ros_common::runNode<ros_mapping::PolygonMapNode>(argc, argv, "polygon_map");
}

#include <iostream>

#include "polygonal_perception/ros/mapping/polygon_map_node.hpp"

int main()
{
  std::cout << polygonal_perception::ros_mapping::PolygonMapNode::parameterTable();
}

#include <iostream>

#include "polygonal_perception/ros/planning/shortest_path_node.hpp"

int main()
{
  std::cout << polygonal_perception::ros_planning::ShortestPathNode::parameterTable();
}

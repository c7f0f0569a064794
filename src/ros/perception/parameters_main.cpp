#include <iostream>

#include "polygonal_perception/ros/perception/perception_node.hpp"

int main()
{
  std::cout << polygonal_perception::ros_perception::PerceptionNode::parameterTable();
}

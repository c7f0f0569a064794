#include <iostream>

#include "polygonal_perception/ros/driving/dynamic_window_node.hpp"

int main()
{
  std::cout << polygonal_perception::ros_driving::DynamicWindowNode::parameterTable();
}

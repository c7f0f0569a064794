#include "polygonal_perception/ros/common/nodelet_of.hpp"
#include "polygonal_perception/ros/driving/dynamic_window_node.hpp"

int main(int argc, char** argv)
{
  using namespace polygonal_perception;
  return ros_common::runNode<ros_driving::DynamicWindowNode>(argc, argv, "dynamic_window");
}

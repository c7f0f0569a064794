#include "polygonal_perception/ros/common/nodelet_of.hpp"
#include "polygonal_perception/ros/perception/perception_node.hpp"

int main(int argc, char** argv)
{
  using namespace polygonal_perception;
  return ros_common::runNode<ros_perception::PerceptionNode>(argc, argv, "polygonal_perception");
}

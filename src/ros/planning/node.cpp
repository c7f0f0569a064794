#include "polygonal_perception/ros/common/nodelet_of.hpp"
#include "polygonal_perception/ros/planning/shortest_path_node.hpp"

int main(int argc, char** argv)
{
  using namespace polygonal_perception;
  return ros_common::runNode<ros_planning::ShortestPathNode>(argc, argv, "shortest_path");
}

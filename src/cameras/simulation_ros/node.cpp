#include "polygonal_perception/cameras/simulation_ros/simulated_camera_node.hpp"
#include "polygonal_perception/ros/common/nodelet_of.hpp"

int main(int argc, char** argv)
{
  using namespace polygonal_perception;
  return ros_common::runNode<simulation_ros::SimulatedCameraNode>(argc, argv, "simulated_camera");
}

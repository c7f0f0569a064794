#include <ros/ros.h>

#include "cameras/simulation_ros/simulated_camera_ros.hpp"

int main(int argc, char** argv)
{
  ros::init(argc, argv, "simulated_camera");
  // They outlive the camera: with the last of them the console goes, and with it the message below.
  const ros::NodeHandle node;
  const ros::NodeHandle private_node("~");
  try {
    const polygonal_perception::simulation_ros::SimulatedCameraRos camera(node, private_node);
    ros::spin();
  } catch (const std::exception& e) {
    ROS_FATAL("The simulated camera cannot start: %s", e.what());
    return 1;
  }
  return 0;
}

#include <ros/ros.h>

#include "simulated_camera_ros.hpp"

int main(int argc, char** argv)
{
  ros::init(argc, argv, "simulated_camera");
  try {
    const polygonal_perception::simulation::SimulatedCameraRos camera(ros::NodeHandle(),
                                                                      ros::NodeHandle("~"));
    ros::spin();
  } catch (const std::exception& e) {
    ROS_FATAL("The simulated camera cannot start: %s", e.what());
    return 1;
  }
  return 0;
}

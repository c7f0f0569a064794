#include <ros/ros.h>

#include "ros/perception/polygonal_perception_ros.hpp"

int main(int argc, char** argv)
{
  ros::init(argc, argv, "polygonal_perception");
  const polygonal_perception::ros_perception::PolygonalPerceptionRos perception(ros::NodeHandle(),
                                                                                ros::NodeHandle("~"));
  ros::spin();
}

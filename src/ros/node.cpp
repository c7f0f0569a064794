#include <ros/ros.h>

#include "polygonal_perception/ros/polygonal_perception_ros.hpp"

int main(int argc, char** argv)
{
  ros::init(argc, argv, "polygonal_perception");
  const polygonal_perception::PolygonalPerceptionRos perception(ros::NodeHandle(), ros::NodeHandle("~"));
  ros::spin();
}

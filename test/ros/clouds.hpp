#pragma once

#include <ros/time.h>
#include <sensor_msgs/PointCloud2.h>

#include <string>

namespace polygonal_perception::test {

/// What a camera 1 m above the floor sees that looks straight ahead: nothing but floor.
sensor_msgs::PointCloud2Ptr floorCloud(ros::Time stamp,
                                       const std::string& frame = "camera_depth_optical_frame");

/// A wall close to the camera, and no floor.
sensor_msgs::PointCloud2Ptr wallCloud(ros::Time stamp,
                                      const std::string& frame = "camera_depth_optical_frame");

}  // namespace polygonal_perception::test

#pragma once

#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

namespace polygonal_perception::ros_perception {

/// A frame in the memory of its publisher: one of the two is set.
struct InputFrame
{
  sensor_msgs::PointCloud2ConstPtr cloud;
  sensor_msgs::ImageConstPtr image;

  const std_msgs::Header& header() const { return cloud ? cloud->header : image->header; }
};

}  // namespace polygonal_perception::ros_perception

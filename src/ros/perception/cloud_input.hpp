#pragma once

#include <sensor_msgs/PointCloud2.h>

#include "polygonal_perception/perception/input/point_view.hpp"
#include "polygonal_perception/ros/common/expected.hpp"

namespace polygonal_perception::ros_perception {

/// A view onto the points of an organised cloud, which must outlive it; nothing is copied.
///
/// @return the view, or an error that names the field, what it was and what is accepted: float32 x, y and z
///         at any offsets, any steps, little-endian, between 2 and 65535 points a row and a column
ros_common::Expected<perception::PointView> viewCloud(const sensor_msgs::PointCloud2& cloud);

}  // namespace polygonal_perception::ros_perception

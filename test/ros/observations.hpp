#pragma once

#include <polygonal_perception/ObservedCells.h>
#include <polygonal_perception/PolygonArray.h>
#include <ros/time.h>
#include <tf2_msgs/TFMessage.h>

#include <string>

namespace polygonal_perception::test {

/// A grid of 2 x 2 m right ahead of its frame, all of it seen, with something that stands a metre ahead.
ObservedCellsPtr observedCells(const ros::Time& stamp, const std::string& frame = "odom");

/// A box of 1 x 2 m, a metre ahead of its frame, in an extent of 10 x 10 m.
PolygonArrayPtr boxAhead(const ros::Time& stamp, const std::string& frame = "odom");

/// A frame in the middle of odom, for /tf or, for all times, for /tf_static.
tf2_msgs::TFMessage inOdom(const std::string& frame, const ros::Time& stamp);

}  // namespace polygonal_perception::test

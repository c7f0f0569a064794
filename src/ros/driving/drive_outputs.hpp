#pragma once

#include "polygonal_perception/ros/common/output_table.hpp"
#include "ros/driving/driver.hpp"

namespace polygonal_perception::ros_driving {

/// What there is to show of a command.
struct DriveResult
{
  const DriveReport& report;
  const planning::DynamicWindow& window;
};

using DriveOutputs = ros_common::OutputTable<DriveResult, ros_common::NoNeeds>;

/// Adds the topics of the node: status, markers.
void addOutputs(DriveOutputs& outputs);

}  // namespace polygonal_perception::ros_driving

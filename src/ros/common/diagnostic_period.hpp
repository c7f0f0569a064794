#pragma once

#include <ros/node_handle.h>

namespace polygonal_perception::ros_common {

/// Where a parameter is read: on the server, or what roscpp has cached of it in this process, which needs no roscore.
enum class PeriodSource
{
  kServer,
  kCache
};

/// The time between two reports [s]. Replaces a `diagnostic_period` on the parameter server that is out of
/// its range, and says so.
///
/// diagnostic_updater reads the parameter itself, at its start and before each report, and throws when no
/// ros::Duration can hold it. A nodelet's manager would not survive that.
double ensureDiagnosticPeriod(const ros::NodeHandle& private_handle, PeriodSource source);

}  // namespace polygonal_perception::ros_common

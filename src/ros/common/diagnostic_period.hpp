#pragma once

#include <ros/node_handle.h>

namespace polygonal_perception::ros_common {

/// The time between two reports [s]. Replaces a `diagnostic_period` on the parameter server that is out of
/// its range, and says so.
///
/// diagnostic_updater reads the parameter itself, at its start and before each report, and throws when no
/// ros::Duration can hold it. A nodelet's manager would not survive that.
double ensureDiagnosticPeriod(const ros::NodeHandle& private_handle);

}  // namespace polygonal_perception::ros_common

#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <ros/wall_timer.h>

#include <functional>
#include <memory>
#include <string>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/ros/common/callback_gate.hpp"
#include "polygonal_perception/ros/common/frame_statistics.hpp"
#include "polygonal_perception/ros/common/input_topics.hpp"
#include "polygonal_perception/ros/common/throttled_log.hpp"

namespace polygonal_perception::ros_common {

/// Reports a node's state on /diagnostics, once a `diagnostic_period` by the wall clock: a bag that stands
/// still is worth a report, too.
class POLYGONAL_PERCEPTION_EXPORT DiagnosticsReporter
{
public:
  using Status = diagnostic_updater::DiagnosticStatusWrapper;

  /// @param handle  whose queue serves the timer
  /// @param gate    what follows is called inside it
  /// @param retry   called before each report: what did not work then may work now
  /// @param fill    fills in a report
  DiagnosticsReporter(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
                      std::shared_ptr<CallbackGate> gate, ThrottledLog& log,
                      std::function<InputTopics::Unsubscribed()> retry, std::function<void(Status&)> fill);

private:
  void report();

  ros::NodeHandle private_handle_;
  ThrottledLog& log_;
  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;
};

/// What became of the frames and how long each stage took, as keys of a report.
POLYGONAL_PERCEPTION_EXPORT void addStatistics(const FrameStatistics& statistics,
                                               DiagnosticsReporter::Status& status);

}  // namespace polygonal_perception::ros_common

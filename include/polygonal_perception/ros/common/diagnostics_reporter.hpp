#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
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
/// still is worth a report, too. The period is read once; one that is out of its range is refused, and 1 s instead.
///
/// It needs no diagnostic_updater::Updater: that reads the period at its start and before each report from what
/// roscpp has cached, which a forerunner in the same manager may have left there, and throws when no
/// ros::Duration can hold it.
class POLYGONAL_PERCEPTION_EXPORT DiagnosticsReporter
{
public:
  using Status = diagnostic_updater::DiagnosticStatusWrapper;

  /// @param handle  whose queue serves the timer
  /// @param gate    what follows is called inside it
  /// @param retry   called before each report: what did not work then may work now
  /// @param fill    fills in a report
  DiagnosticsReporter(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
                      const std::shared_ptr<CallbackGate>& gate, ThrottledLog& log,
                      std::function<InputTopics::Unsubscribed()> retry, std::function<void(Status&)> fill);

private:
  void report();

  const std::string name_;
  const std::function<void(Status&)> fill_;
  ThrottledLog& log_;
  ros::Publisher publisher_;
  ros::WallTimer timer_;
};

/// What became of the frames and how long each stage took, as keys of a report.
POLYGONAL_PERCEPTION_EXPORT void addStatistics(const FrameStatistics& statistics,
                                               DiagnosticsReporter::Status& status);

}  // namespace polygonal_perception::ros_common

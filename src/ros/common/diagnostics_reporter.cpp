#include "polygonal_perception/ros/common/diagnostics_reporter.hpp"

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/console.h>

#include <exception>
#include <utility>

#include "polygonal_perception/parameters/parameter_check.hpp"

namespace polygonal_perception::ros_common {
namespace {

/// [s] between two reports, by the parameter.
double readPeriod(const ros::NodeHandle& private_handle)
{
  constexpr char kName[] = "diagnostic_period";
  constexpr parameters::Range kRange{0.01, 3600.0};
  constexpr double kDefault = 1.0;  // diagnostic_updater's
  double period = kDefault;
  private_handle.getParam(kName, period);
  // Written so that NaN fails.
  if (period >= kRange.min && period <= kRange.max) return period;
  ROS_ERROR_STREAM("parameter " << private_handle.resolveName(kName) << " is " << period << ", accepted is "
                                << parameters::rangeText(kRange, "s") << "; it becomes " << kDefault);
  private_handle.setParam(kName, kDefault);
  return kDefault;
}

}  // namespace

DiagnosticsReporter::DiagnosticsReporter(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
                                         const std::shared_ptr<CallbackGate>& gate, ThrottledLog& log,
                                         std::function<InputTopics::Unsubscribed()> retry,
                                         std::function<void(Status&)> fill)
    : name_(private_handle.getNamespace().substr(1) + ": frames"),
      fill_(std::move(fill)),
      log_(log),
      publisher_(ros::NodeHandle(handle).advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 1))
{
  timer_ =
      ros::NodeHandle(handle).createWallTimer(ros::WallDuration(readPeriod(private_handle)),
                                              unsubscribingOutside(gate, [this, retry = std::move(retry)] {
                                                InputTopics::Unsubscribed unsubscribed = retry();
                                                report();
                                                return unsubscribed;
                                              }));
}

void DiagnosticsReporter::report()
{
  Status status;
  status.name = name_;
  status.hardware_id = "none";
  try {
    fill_(status);
  } catch (const std::exception& error) {
    log_.error("diagnostics", std::string("no diagnostics: ") + error.what());
    return;
  }
  diagnostic_msgs::DiagnosticArray report;
  report.header.stamp = ros::Time::now();
  report.status.push_back(status);
  publisher_.publish(report);
}

void addStatistics(const FrameStatistics& statistics, DiagnosticsReporter::Status& status)
{
  status.add("Frames answered", statistics.answeredCount());
  status.add("Frames rejected", statistics.rejectedCount());
  status.add("Last rejection", statistics.lastRejection().empty() ? "none" : statistics.lastRejection());
  status.add("Frames dropped", statistics.droppedCount());
  for (const auto& [name, stage] : statistics.stages()) {
    status.addf("Time of " + name + " mean [ms]", "%.3f", stage.meanMs());
    status.addf("Time of " + name + " max [ms]", "%.3f", stage.maxMs());
  }
}

}  // namespace polygonal_perception::ros_common

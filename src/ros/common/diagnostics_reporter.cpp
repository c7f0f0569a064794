#include "polygonal_perception/ros/common/diagnostics_reporter.hpp"

#include <exception>
#include <utility>

#include "ros/common/diagnostic_period.hpp"

namespace polygonal_perception::ros_common {

namespace {

/// The updater reads the period when it is made, from the server: by then it must be one that it survives. What an
/// earlier node of this process has cached may be another one.
const ros::NodeHandle& withCheckedPeriod(const ros::NodeHandle& private_handle)
{
  ensureDiagnosticPeriod(private_handle, PeriodSource::kServer);
  return private_handle;
}

}  // namespace

DiagnosticsReporter::DiagnosticsReporter(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
                                         std::shared_ptr<CallbackGate> gate, ThrottledLog& log,
                                         std::function<InputTopics::Unsubscribed()> retry,
                                         std::function<void(Status&)> fill)
    : private_handle_(withCheckedPeriod(private_handle)),
      log_(log),
      updater_(handle, private_handle, private_handle.getNamespace())
{
  updater_.setHardwareID("none");
  updater_.add("frames", std::move(fill));
  // The updater may have read another value, one that never ends, of a parameter that changes just now.
  timer_ = ros::NodeHandle(handle).createWallTimer(
      ros::WallDuration(ensureDiagnosticPeriod(private_handle_, PeriodSource::kCache)),
      unsubscribingOutside(gate, [this, retry = std::move(retry)] {
        InputTopics::Unsubscribed unsubscribed = retry();
        report();
        return unsubscribed;
      }));
}

void DiagnosticsReporter::report()
{
  ensureDiagnosticPeriod(private_handle_, PeriodSource::kCache);
  // It adds its period to the clock, which throws at the end of ROS's time.
  try {
    updater_.force_update();
  } catch (const std::exception& error) {
    log_.error("diagnostics", std::string("no diagnostics: ") + error.what());
  }
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

#include "ros/common/diagnostic_period.hpp"

#include <ros/console.h>

#include "polygonal_perception/parameters/parameter_check.hpp"

namespace polygonal_perception::ros_common {

double ensureDiagnosticPeriod(const ros::NodeHandle& private_handle, PeriodSource source)
{
  constexpr char kName[] = "diagnostic_period";
  constexpr parameters::Range kRange{0.01, 3600.0};
  constexpr double kDefault = 1.0;  // diagnostic_updater's
  double period = kDefault;
  if (source == PeriodSource::kServer) {
    private_handle.getParam(kName, period);
  } else {
    private_handle.getParamCached(kName, period);
  }
  // Written so that NaN fails.
  if (period >= kRange.min && period <= kRange.max) return period;
  ROS_ERROR_STREAM("parameter " << private_handle.resolveName(kName) << " is " << period << ", accepted is "
                                << parameters::rangeText(kRange, "s") << "; it becomes " << kDefault);
  private_handle.setParam(kName, kDefault);
  return kDefault;
}

}  // namespace polygonal_perception::ros_common

#include "ros/mapping/map_diagnostics.hpp"

namespace polygonal_perception::ros_mapping {

using diagnostic_msgs::DiagnosticStatus;

void fillDiagnostics(const MapSources& sources, const ros_common::FrameStatistics& statistics,
                     ros_common::FrameStatistics::Clock::time_point now,
                     ros_common::DiagnosticsReporter::Status& status)
{
  status.summary(DiagnosticStatus::OK, "mapping");
  std::size_t silent = 0;
  for (std::size_t k = 0; k < sources.size(); ++k) {
    const std::string complaint = sources.complaint(k, now);
    silent += statistics.silence(now) > 1.0 && !complaint.empty() ? 1 : 0;
    status.add("Source " + sources.name(k), complaint.empty() ? "OK" : complaint);
    if (!complaint.empty()) status.mergeSummary(DiagnosticStatus::WARN, sources.name(k) + ": " + complaint);
  }
  if (const std::string disagreement = sources.disagreement(); !disagreement.empty()) {
    status.mergeSummary(DiagnosticStatus::WARN, disagreement);
    status.add("Floors", disagreement);
  }
  if (silent == sources.size()) {
    status.mergeSummary(DiagnosticStatus::ERROR, "no observation comes");
  } else if (statistics.recentlyReceived() > 0 &&
             statistics.recentlyRejected() >= statistics.recentlyReceived()) {
    status.mergeSummary(DiagnosticStatus::ERROR,
                        "every observation is rejected: " + statistics.lastRejection());
  }
  status.addf("Input rate [Hz]", "%.1f", statistics.rate(now));
  ros_common::addStatistics(statistics, status);
}

}  // namespace polygonal_perception::ros_mapping

#include "ros/perception/diagnostics.hpp"

#include "polygonal_perception/geometry/angle.hpp"
#include "polygonal_perception/parameters/parameter_check.hpp"
#include "ros/perception/floor_absence_text.hpp"

namespace polygonal_perception::ros_perception {

namespace {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

constexpr double kLongSilence = 2.0;  // [s] without a frame that are an error

const char* textOf(perception::FloorStatus status)
{
  switch (status) {
    case perception::FloorStatus::kFound:
      return "FOUND";
    case perception::FloorStatus::kHeld:
      return "HELD";
    case perception::FloorStatus::kAssumed:
      return "ASSUMED";
    case perception::FloorStatus::kNotFound:
      break;
  }
  return "NOT_FOUND";
}

/// The axis of the input's frame that is x of the floor frame, and why.
std::string headingText(const perception::ViewAxes& heading)
{
  using Source = perception::ViewAxes::Source;
  const Eigen::Vector3d& axis = heading.forward;
  std::string text = "(" + parameters::numberText(axis.x()) + ", " + parameters::numberText(axis.y()) + ", " +
                     parameters::numberText(axis.z()) + "): ";
  switch (heading.source) {
    case Source::kPixels:
      return text + "where the cloud's pixels look";
    case Source::kBodyFrame:
      return text + "x of a body frame, as initial_up is";
    case Source::kParameter:
      return text + "the parameter forward";
    case Source::kConvention:
      break;
  }
  return text + "the viewing axis of an optical frame";
}

void summarize(const NodeState& state, const ros_common::FrameStatistics& statistics, double silence,
               DiagnosticStatusWrapper& status)
{
  if (!state.subscription_error.empty()) {
    status.summary(DiagnosticStatus::ERROR, "cannot subscribe to " + state.subscription_error);
  } else if (!state.active) {
    status.summary(DiagnosticStatus::OK, "idle: nobody reads an output");
  } else if (silence > kLongSilence) {
    status.summaryf(DiagnosticStatus::ERROR, "no frame for %.1f s: waiting for %s%s", silence,
                    state.awaited_topic.c_str(), publicationText(state).c_str());
  } else if (statistics.recentlyReceived() > 0 &&
             statistics.recentlyRejected() >= statistics.recentlyReceived()) {
    status.summary(DiagnosticStatus::ERROR, "every frame is rejected: " + statistics.lastRejection());
  } else if (state.floor.status == perception::FloorStatus::kNotFound) {
    status.summary(DiagnosticStatus::WARN, "no floor in view");
  } else if (state.floor.status == perception::FloorStatus::kHeld) {
    status.summaryf(DiagnosticStatus::OK, "floor held for %.2f s", state.floor.age);
  } else if (state.floor.status == perception::FloorStatus::kAssumed) {
    status.summary(DiagnosticStatus::OK, "floor assumed where mount_frame says");
  } else if (!state.mount_disagreement.empty()) {
    status.summary(DiagnosticStatus::WARN, state.mount_disagreement);
  } else {
    status.summary(DiagnosticStatus::OK, "floor found");
  }
}

}  // namespace

std::string publicationText(const NodeState& state)
{
  if (state.awaited_is_published) return {};
  if (state.awaited_other_type.empty()) return ", which nobody publishes";
  return ", which is published as " + state.awaited_other_type + ": not what this node reads";
}

void fillDiagnostics(const NodeState& state, const ros_common::FrameStatistics& statistics,
                     ros_common::FrameStatistics::Clock::time_point now, DiagnosticStatusWrapper& status)
{
  summarize(state, statistics, statistics.silence(now), status);
  status.addf("Input rate [Hz]", "%.1f", statistics.rate(now));
  status.add("Floor", textOf(state.floor.status));
  if (state.floor.absence) status.add("Floor not seen because", absenceText(*state.floor.absence));
  if (state.floor.status != perception::FloorStatus::kNotFound) {
    status.addf("Camera height [m]", "%.3f", state.floor.floor.plane.distance);
    status.add("Ahead", headingText(state.heading));
    if (state.attitude) {
      status.addf("Camera pitch [deg]", "%.2f", state.attitude->pitch / geometry::kDegree);
      status.addf("Camera roll [deg]", "%.2f", state.attitude->roll / geometry::kDegree);
    }
    status.addf("Floor rms error [m]", "%.4f", state.floor.floor.rms_error);
  }
  ros_common::addStatistics(statistics, status);
}

}  // namespace polygonal_perception::ros_perception

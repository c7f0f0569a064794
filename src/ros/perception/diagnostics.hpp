#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <optional>
#include <string>

#include "polygonal_perception/perception/floor/floor_tracker.hpp"
#include "polygonal_perception/perception/floor/view_axes.hpp"
#include "polygonal_perception/ros/common/diagnostics_reporter.hpp"
#include "polygonal_perception/ros/common/frame_statistics.hpp"
#include "ros/perception/camera_attitude.hpp"

namespace polygonal_perception::ros_perception {

/// What the node is doing, as far as its diagnostics tell.
struct NodeState
{
  bool active = false;             ///< subscribed to the camera
  std::string subscription_error;  ///< why it could not subscribe, else empty
  std::string awaited_topic;       ///< resolved name of the input that it cannot go on without
  bool awaited_is_published = false;
  std::string awaited_other_type;  ///< as what it is published instead, or empty
  perception::FloorState floor;
  perception::ViewAxes heading;            ///< of the floor frame
  std::optional<CameraAttitude> attitude;  ///< where there is a floor
  std::string mount_disagreement;          ///< where it was found elsewhere than mount_frame says, else empty
};

/// What is wrong with the publication of the awaited topic, as the end of a sentence; empty where nothing is.
std::string publicationText(const NodeState& state);

/// Fills in a diagnostic status: OK when idle or with a floor, WARN without one, ERROR where frames fail to
/// come or all are rejected.
void fillDiagnostics(const NodeState& state, const ros_common::FrameStatistics& statistics,
                     ros_common::FrameStatistics::Clock::time_point now,
                     diagnostic_updater::DiagnosticStatusWrapper& status);

}  // namespace polygonal_perception::ros_perception

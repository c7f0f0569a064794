#pragma once

#include "polygonal_perception/ros/common/diagnostics_reporter.hpp"
#include "polygonal_perception/ros/common/frame_statistics.hpp"
#include "ros/mapping/map_sources.hpp"

namespace polygonal_perception::ros_mapping {

/// Fills in a diagnostic status: ERROR where nothing comes or all is rejected, WARN where a source is silent, late or
/// without a floor, or two floors disagree; else OK. Each source has a line of its own.
void fillDiagnostics(const MapSources& sources, const ros_common::FrameStatistics& statistics,
                     ros_common::FrameStatistics::Clock::time_point now,
                     ros_common::DiagnosticsReporter::Status& status);

}  // namespace polygonal_perception::ros_mapping

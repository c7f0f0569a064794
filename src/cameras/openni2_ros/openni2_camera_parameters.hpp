#pragma once

#include <optional>
#include <string>

#include "cameras/openni2/depth_modes.hpp"
#include "polygonal_perception/cameras/openni2/openni2_source.hpp"
#include "polygonal_perception/parameters/parameter_check.hpp"
#include "polygonal_perception/parameters/parameter_table.hpp"
#include "polygonal_perception/ros/common/text_rules.hpp"

namespace polygonal_perception::openni2_ros {

/// Every parameter of the node, under openni2_camera's names.
struct OpenNI2CameraParameters
{
  openni2::SourceOptions source;
  int depth_mode = 0;  ///< stands for width, height and rate; 0: none does
  std::string depth_frame_id = "camera_depth_optical_frame";
  std::string depth_camera_info_url;
  std::string rgb_frame_id = "camera_rgb_optical_frame";
  std::string rgb_camera_info_url;

  /// The camera whose view the depth is: with registration the colour camera's.
  const char* view() const { return source.registration ? "rgb" : "depth"; }
  const std::string& frameId() const { return source.registration ? rgb_frame_id : depth_frame_id; }
  const std::string& cameraInfoUrl() const
  {
    return source.registration ? rgb_camera_info_url : depth_camera_info_url;
  }
  openni2::SourceOptions options() const
  {
    openni2::SourceOptions options = source;
    openni2::setDepthMode(depth_mode, options);
    return options;
  }

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor&& visit)
  {
    using parameters::Range;
    using ros_common::kFrame;
    using ros_common::kUrlOrEmpty;
    visit("device_id", self.source.device_id, parameters::TextRule{"a device", ros_common::isAnyText},
          "Number, bus, serial number, URI or recording.");
    visit("width", self.source.width, Range{1, 8192}.atStart(), "px", "Of the image.");
    visit("height", self.source.height, Range{1, 8192}.atStart(), "px", "Of the image.");
    visit("rate", self.source.rate, Range{1, 1000}.atStart(), "Hz", "Frames a second.");
    visit("depth_mode", self.depth_mode, Range{0, openni2::kDepthModeCount}.atStart(), "",
          "openni2_camera's number for the three; 0: as they are.");
    visit("depth_registration", self.source.registration, "Depth as the colour camera sees it.");
    visit("mirror", self.source.mirror, "Left and right swapped.");
    visit("loop", self.source.loop, "A recording begins again at its end.");
    visit("depth_frame_id", self.depth_frame_id, kFrame, "Of the images.");
    visit("depth_camera_info_url", self.depth_camera_info_url, kUrlOrEmpty,
          "Of the calibration; empty: the device's own.");
    visit("rgb_frame_id", self.rgb_frame_id, kFrame, "Of the images with depth_registration.");
    visit("rgb_camera_info_url", self.rgb_camera_info_url, kUrlOrEmpty,
          "Of the calibration with depth_registration.");
  }

  std::optional<parameters::ParameterFault> conflict() const { return std::nullopt; }
};

}  // namespace polygonal_perception::openni2_ros

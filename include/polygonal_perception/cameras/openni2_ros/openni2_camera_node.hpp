#pragma once

#include <ros/node_handle.h>

#include <memory>

#include "polygonal_perception/export.hpp"

namespace polygonal_perception::openni2_ros {

/// Publishes the depth of an OpenNI2 camera or recording under the names that openni2_launch uses:
/// depth/image_raw (16UC1, mm, 0 = none) with depth/camera_info, and, unless a calibration is named, the same
/// image as depth/image_rect_raw and depth/image_rect, since the device's depth comes without distortion.
/// With a calibration image_proc/rectify has to make them. The stream runs while one of them has a reader.
///
/// Private parameters: device_id ("#1"; see openni2::SourceOptions); width (640), height (480) [px] and rate
/// (30) [Hz], or depth_mode, a number that stands for the three as in openni2_camera; depth_registration
/// (false), mirror (false), loop (true); depth_frame_id (camera_depth_optical_frame) and
/// depth_camera_info_url (empty: no calibration), or with registration rgb_frame_id
/// (camera_rgb_optical_frame) and rgb_camera_info_url.
class POLYGONAL_PERCEPTION_EXPORT OpenNI2CameraNode
{
public:
  /// Returns at once; the device is looked for on a thread of its own.
  OpenNI2CameraNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle);
  ~OpenNI2CameraNode();
  OpenNI2CameraNode(const OpenNI2CameraNode&) = delete;
  OpenNI2CameraNode& operator=(const OpenNI2CameraNode&) = delete;

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace polygonal_perception::openni2_ros

#pragma once

#include <image_transport/image_transport.h>
#include <ros/ros.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "cameras/openni2_ros/depth_calibration.hpp"
#include "polygonal_perception/cameras/openni2/device_clock.hpp"
#include "polygonal_perception/cameras/openni2/openni2_source.hpp"
#include "polygonal_perception/export.hpp"

namespace polygonal_perception::openni2_ros {

/// Publishes the depth of an OpenNI2 camera or recording under the names that openni2_launch uses:
/// depth/image_raw (16UC1, mm, 0 = none) with depth/camera_info, and, unless a calibration is named, the same
/// image as depth/image_rect_raw and depth/image_rect, since the device's depth comes without distortion.
/// With a calibration image_proc/rectify has to make them. The stream runs while one of them has a reader.
///
/// Private parameters: device_id ("#1"; see SourceOptions); width (640), height (480) [px] and rate (30)
/// [Hz], or depth_mode, a number that stands for the three as in openni2_camera; depth_registration (false),
/// mirror (false), loop (true); depth_frame_id (camera_depth_optical_frame) and depth_camera_info_url (empty:
/// no calibration), or with registration rgb_frame_id (camera_rgb_optical_frame) and rgb_camera_info_url.
class POLYGONAL_PERCEPTION_EXPORT OpenNI2CameraRos
{
public:
  /// Returns at once; the device is looked for on a thread of its own.
  OpenNI2CameraRos(const ros::NodeHandle& node, const ros::NodeHandle& private_node);
  ~OpenNI2CameraRos();
  OpenNI2CameraRos(const OpenNI2CameraRos&) = delete;
  OpenNI2CameraRos& operator=(const OpenNI2CameraRos&) = delete;

private:
  void onReaders();
  void onFrame(const openni2::DepthFrame& frame);

  std::mutex mutex_;  // of source_, which readers that come and go speak to
  std::string frame_id_;
  std::uint32_t sequence_ = 0;  // of the last frame: roscpp numbers messages for other processes only
  openni2::DeviceClock clock_;
  std::unique_ptr<DepthCalibration> calibration_;
  image_transport::CameraPublisher raw_;
  std::vector<image_transport::Publisher> rectified_;
  std::unique_ptr<openni2::OpenNI2Source> source_;
};

}  // namespace polygonal_perception::openni2_ros

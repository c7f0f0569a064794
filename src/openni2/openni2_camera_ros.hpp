#pragma once

#include <image_transport/image_transport.h>
#include <ros/ros.h>

#include <memory>
#include <mutex>
#include <string>

#include "polygonal_perception/openni2/device_clock.hpp"
#include "polygonal_perception/openni2/openni2_source.hpp"

namespace polygonal_perception {
namespace openni2 {

/// Publishes the depth of an OpenNI2 camera or recording under the names that openni2_camera uses:
/// depth/image_raw (16UC1, mm, 0 = none) with depth/camera_info, and depth/image_rect, the same image, since
/// the device's depth comes without distortion. The stream runs while one of them has a reader.
///
/// Private parameters: device_id ("#1"; see SourceOptions), width (640), height (480) [px], rate (30) [Hz],
/// depth_registration (false), mirror (false), loop (true), depth_frame_id (camera_depth_optical_frame), and
/// rgb_frame_id (camera_rgb_optical_frame), the frame of registered depth.
class OpenNI2CameraRos
{
public:
  /// Returns at once; the device is looked for on a thread of its own.
  OpenNI2CameraRos(const ros::NodeHandle& node, const ros::NodeHandle& private_node);
  ~OpenNI2CameraRos();
  OpenNI2CameraRos(const OpenNI2CameraRos&) = delete;
  OpenNI2CameraRos& operator=(const OpenNI2CameraRos&) = delete;

private:
  void onReaders();
  void onFrame(const DepthFrame& frame);

  std::mutex mutex_;  // of source_, which readers that come and go speak to
  std::string frame_id_;
  DeviceClock clock_;
  image_transport::CameraPublisher raw_;
  image_transport::Publisher rectified_;
  std::unique_ptr<OpenNI2Source> source_;
};

}  // namespace openni2
}  // namespace polygonal_perception

#pragma once

#include <camera_info_manager/camera_info_manager.h>
#include <ros/node_handle.h>
#include <sensor_msgs/CameraInfo.h>

#include <memory>
#include <string>

#include "polygonal_perception/cameras/openni2/openni2_source.hpp"

namespace polygonal_perception::openni2_ros {

/// The camera_info of depth images: a calibration that camera_info_manager keeps, or that of a pinhole with
/// the stream's field of view, of the camera that sees them; and their offset against its image.
class DepthCalibration
{
public:
  /// @param node  where the service set_camera_info is, if there is a URL
  /// @param name  of the camera; with "_<serial number>" where the device tells one it is ${NAME} in the URL
  /// @param url   of the calibration; empty: the pinhole
  DepthCalibration(const ros::NodeHandle& node, std::string name, const std::string& url);

  /// Of a frame. A calibration for another size of the image is not used, and the log says so once.
  sensor_msgs::CameraInfoPtr cameraInfo(const openni2::DepthFrame& frame, const std_msgs::Header& header);

private:
  bool fits(const sensor_msgs::CameraInfo& info, const openni2::DepthFrame& frame);

  std::string name_;
  std::string serial_;
  bool has_warned_ = false;
  std::unique_ptr<camera_info_manager::CameraInfoManager> manager_;  // only with a URL
};

}  // namespace polygonal_perception::openni2_ros

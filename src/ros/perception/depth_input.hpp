#pragma once

#include <ros/time.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include <optional>
#include <string>
#include <utility>

#include "polygonal_perception/perception/input/point_view.hpp"
#include "polygonal_perception/ros/common/expected.hpp"

namespace polygonal_perception::ros_perception {

/// Turns rectified depth images into views onto their points, by the camera's latest calibration.
///
/// A camera_info need not come with every image. But where the two have come in pairs of one stamp, the
/// image's own info is worth a moment's wait, since either may arrive first and a camera's calibration may
/// change.
class DepthInput
{
public:
  /// @param info_topic  where the calibration comes from, for errors
  explicit DepthInput(std::string info_topic) : info_topic_(std::move(info_topic)) {}

  /// Takes on a calibration.
  void setCameraInfo(const sensor_msgs::CameraInfoConstPtr& info);

  /// Whether the camera_info of this image is still to be expected.
  bool awaitsCameraInfo(const sensor_msgs::Image& image) const;

  /// A view onto the image's points, which lives as long as the image and until the next call; nothing is
  /// copied.
  /// @param unit  [m] of the numbers in a 16UC1 image
  /// @return the view, or an error that names the field, what it was and what is accepted: 16UC1 or
  ///         32FC1 in metres, little-endian, and a camera_info of the same size with positive
  ///         focal lengths
  ros_common::Expected<perception::PointView> view(const sensor_msgs::Image& image, double unit = 0.001);

  /// What is to be said of the calibration that the last view took on, once for each; empty: nothing.
  std::string takeNotice() { return std::exchange(notice_, {}); }

private:
  std::string adoptCalibration(const sensor_msgs::Image& image);

  std::string info_topic_;
  std::string notice_;
  sensor_msgs::CameraInfoConstPtr info_;
  sensor_msgs::CameraInfoConstPtr info_of_rays_;
  std::optional<ros::Time> last_image_;
  bool in_pairs_ = false;
  perception::PinholeRays rays_;
};

}  // namespace polygonal_perception::ros_perception

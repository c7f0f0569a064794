#include "cameras/openni2_ros/depth_calibration.hpp"

#include <boost/make_shared.hpp>
#include <utility>

namespace polygonal_perception::openni2_ros {
namespace {

sensor_msgs::CameraInfo pinhole(const openni2::DepthFrame& frame)
{
  // Pixel centres lie at integers.
  const double cx = 0.5 * (frame.width - 1.0);
  const double cy = 0.5 * (frame.height - 1.0);
  const double f = frame.focal_length;
  sensor_msgs::CameraInfo info;
  info.width = frame.width;
  info.height = frame.height;
  info.distortion_model = "plumb_bob";
  info.D.assign(5, 0.0);
  info.K = {f, 0.0, cx, 0.0, f, cy, 0.0, 0.0, 1.0};
  info.R = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  info.P = {f, 0.0, cx, 0.0, 0.0, f, cy, 0.0, 0.0, 0.0, 1.0, 0.0};
  return info;
}

}  // namespace

DepthCalibration::DepthCalibration(const ros::NodeHandle& node, std::string name, const std::string& url)
    : name_(std::move(name))
{
  if (!url.empty()) manager_ = std::make_unique<camera_info_manager::CameraInfoManager>(node, name_, url);
}

sensor_msgs::CameraInfoPtr DepthCalibration::cameraInfo(const openni2::DepthFrame& frame,
                                                        const std_msgs::Header& header)
{
  auto info = boost::make_shared<sensor_msgs::CameraInfo>();
  if (manager_) {
    if (frame.serial != serial_) {
      serial_ = frame.serial;
      manager_->setCameraName(serial_.empty() ? name_ : name_ + "_" + serial_);
    }
    if (manager_->isCalibrated()) *info = manager_->getCameraInfo();
  }
  if (!fits(*info, frame)) *info = pinhole(frame);
  info->K[2] += frame.offset_x;
  info->K[5] += frame.offset_y;
  info->P[2] += frame.offset_x;
  info->P[6] += frame.offset_y;
  info->header = header;
  return info;
}

bool DepthCalibration::fits(const sensor_msgs::CameraInfo& info, const openni2::DepthFrame& frame)
{
  if (info.width == frame.width && info.height == frame.height) return true;
  if (manager_ && !has_warned_) {
    has_warned_ = true;
    if (info.width == 0) {
      ROS_WARN("%s has no calibration: the camera_info is that of the stream's field of view", name_.c_str());
    } else {
      ROS_WARN(
          "%s is calibrated for %ux%u, its images are %ux%u: the camera_info is that of the stream's "
          "field of view",
          name_.c_str(), info.width, info.height, frame.width, frame.height);
    }
  }
  return false;
}

}  // namespace polygonal_perception::openni2_ros

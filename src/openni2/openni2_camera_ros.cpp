#include "openni2_camera_ros.hpp"

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/image_encodings.h>

#include <boost/make_shared.hpp>
#include <cstring>

namespace polygonal_perception {
namespace openni2 {
namespace {

SourceOptions readOptions(const ros::NodeHandle& node)
{
  SourceOptions options;
  node.param("device_id", options.device_id, options.device_id);
  node.param("width", options.width, options.width);
  node.param("height", options.height, options.height);
  node.param("rate", options.rate, options.rate);
  node.param("depth_registration", options.registration, options.registration);
  node.param("mirror", options.mirror, options.mirror);
  node.param("loop", options.loop, options.loop);
  return options;
}

sensor_msgs::ImagePtr toImage(const DepthFrame& frame, const std_msgs::Header& header)
{
  auto image = boost::make_shared<sensor_msgs::Image>();
  image->header = header;
  image->width = frame.width;
  image->height = frame.height;
  image->encoding = sensor_msgs::image_encodings::TYPE_16UC1;
  image->step = frame.width * static_cast<std::uint32_t>(sizeof(std::uint16_t));
  image->data.resize(std::size_t{image->step} * frame.height);
  for (std::size_t row = 0; row < frame.height; ++row)
    std::memcpy(image->data.data() + row * image->step, frame.data + row * frame.step, image->step);
  return image;
}

sensor_msgs::CameraInfoPtr toCameraInfo(const DepthFrame& frame, const std_msgs::Header& header)
{
  // Pixel centres lie at integers.
  const double cx = 0.5 * (frame.width - 1.0);
  const double cy = 0.5 * (frame.height - 1.0);
  const double f = frame.focal_length;
  auto info = boost::make_shared<sensor_msgs::CameraInfo>();
  info->header = header;
  info->width = frame.width;
  info->height = frame.height;
  info->distortion_model = "plumb_bob";
  info->D.assign(5, 0.0);
  info->K = {f, 0.0, cx, 0.0, f, cy, 0.0, 0.0, 1.0};
  info->R = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  info->P = {f, 0.0, cx, 0.0, 0.0, f, cy, 0.0, 0.0, 0.0, 1.0, 0.0};
  return info;
}

}  // namespace

OpenNI2CameraRos::OpenNI2CameraRos(const ros::NodeHandle& node, const ros::NodeHandle& private_node)
{
  const SourceOptions options = readOptions(private_node);
  frame_id_ = options.registration
                  ? private_node.param<std::string>("rgb_frame_id", "camera_rgb_optical_frame")
                  : private_node.param<std::string>("depth_frame_id", "camera_depth_optical_frame");

  // Readers may come while this is under way: they wait until all members are there.
  const std::lock_guard<std::mutex> lock(mutex_);
  image_transport::ImageTransport transport(node);
  const auto on_image = [this](const image_transport::SingleSubscriberPublisher&) { onReaders(); };
  const auto on_info = [this](const ros::SingleSubscriberPublisher&) { onReaders(); };
  raw_ = transport.advertiseCamera("depth/image_raw", 1, on_image, on_image, on_info, on_info);
  rectified_ = transport.advertise("depth/image_rect", 1, on_image, on_image);
  source_ = std::make_unique<OpenNI2Source>(
      options, [this](const DepthFrame& frame) { onFrame(frame); },
      [name = private_node.getNamespace()](Severity severity, const std::string& text) {
        if (severity == Severity::kWarning) {
          ROS_WARN("%s: %s", name.c_str(), text.c_str());
        } else {
          ROS_INFO("%s: %s", name.c_str(), text.c_str());
        }
      });
}

OpenNI2CameraRos::~OpenNI2CameraRos()
{
  // The source publishes, and readers call the source: it ends first.
  const std::lock_guard<std::mutex> lock(mutex_);
  source_.reset();
}

void OpenNI2CameraRos::onReaders()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (source_) source_->setStreaming(raw_.getNumSubscribers() + rectified_.getNumSubscribers() > 0);
}

void OpenNI2CameraRos::onFrame(const DepthFrame& frame)
{
  std_msgs::Header header;
  header.frame_id = frame_id_;
  header.stamp.fromSec(clock_.toHost(frame.timestamp, ros::Time::now().toSec()));
  const sensor_msgs::ImageConstPtr image = toImage(frame, header);
  raw_.publish(image, toCameraInfo(frame, header));
  if (rectified_.getNumSubscribers() > 0) rectified_.publish(image);
}

}  // namespace openni2
}  // namespace polygonal_perception

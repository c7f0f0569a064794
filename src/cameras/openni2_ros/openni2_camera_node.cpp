#include "polygonal_perception/cameras/openni2_ros/openni2_camera_node.hpp"

#include <image_transport/image_transport.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/image_encodings.h>

#include <boost/make_shared.hpp>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <string>
#include <vector>

#include "cameras/openni2_ros/depth_calibration.hpp"
#include "cameras/openni2_ros/openni2_camera_parameters.hpp"
#include "polygonal_perception/cameras/openni2/device_clock.hpp"
#include "polygonal_perception/cameras/openni2/openni2_source.hpp"
#include "polygonal_perception/ros/common/parameter_holder.hpp"

namespace polygonal_perception::openni2_ros {
namespace {

sensor_msgs::ImagePtr toImage(const openni2::DepthFrame& frame, const std_msgs::Header& header)
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

}  // namespace

class OpenNI2CameraNode::Implementation
{
public:
  Implementation(const ros::NodeHandle& node, const ros::NodeHandle& private_node);
  ~Implementation();

private:
  void onReaders();
  void onFrame(const openni2::DepthFrame& frame);

  const ros_common::ParameterHolder<OpenNI2CameraParameters> parameters_;
  std::mutex mutex_;            // of source_, which readers that come and go speak to
  std::uint32_t sequence_ = 0;  // of the last frame: roscpp numbers messages for other processes only
  openni2::DeviceClock clock_;
  std::unique_ptr<DepthCalibration> calibration_;
  image_transport::CameraPublisher raw_;
  std::vector<image_transport::Publisher> rectified_;
  std::unique_ptr<openni2::OpenNI2Source> source_;
};

OpenNI2CameraNode::Implementation::Implementation(const ros::NodeHandle& node,
                                                  const ros::NodeHandle& private_node)
    : parameters_(private_node)
{
  const std::string& url = parameters_->cameraInfoUrl();
  calibration_ = std::make_unique<DepthCalibration>(ros::NodeHandle(node, "depth"), parameters_->view(), url);

  // Readers may come while this is under way: they wait until all members are there.
  const std::lock_guard<std::mutex> lock(mutex_);
  image_transport::ImageTransport transport(node);
  const auto on_image = [this](const image_transport::SingleSubscriberPublisher&) { onReaders(); };
  const auto on_info = [this](const ros::SingleSubscriberPublisher&) { onReaders(); };
  raw_ = transport.advertiseCamera("depth/image_raw", 1, on_image, on_image, on_info, on_info);
  if (url.empty()) {
    for (const char* name : {"depth/image_rect", "depth/image_rect_raw"})
      rectified_.push_back(transport.advertise(name, 1, on_image, on_image));
  }
  source_ = std::make_unique<openni2::OpenNI2Source>(
      parameters_->options(), [this](const openni2::DepthFrame& frame) { onFrame(frame); },
      [name = private_node.getNamespace()](openni2::Severity severity, const std::string& text) {
        if (severity == openni2::Severity::kWarning) {
          ROS_WARN("%s: %s", name.c_str(), text.c_str());
        } else {
          ROS_INFO("%s: %s", name.c_str(), text.c_str());
        }
      });
}

OpenNI2CameraNode::Implementation::~Implementation()
{
  // The source publishes, and readers call the source: it ends first.
  const std::lock_guard<std::mutex> lock(mutex_);
  source_.reset();
}

void OpenNI2CameraNode::Implementation::onReaders()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!source_) return;
  std::uint32_t readers = raw_.getNumSubscribers();
  for (const image_transport::Publisher& publisher : rectified_) readers += publisher.getNumSubscribers();
  source_->setStreaming(readers > 0);
}

void OpenNI2CameraNode::Implementation::onFrame(const openni2::DepthFrame& frame)
{
  std_msgs::Header header;
  header.seq = ++sequence_;
  header.frame_id = parameters_->frameId();
  header.stamp.fromSec(clock_.toHost(frame.timestamp, ros::Time::now().toSec()));
  const sensor_msgs::ImageConstPtr image = toImage(frame, header);
  raw_.publish(image, calibration_->cameraInfo(frame, header));
  for (const image_transport::Publisher& publisher : rectified_) {
    if (publisher.getNumSubscribers() > 0) publisher.publish(image);
  }
}

OpenNI2CameraNode::OpenNI2CameraNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle)
    : implementation_(std::make_unique<Implementation>(handle, private_handle))
{
}
OpenNI2CameraNode::~OpenNI2CameraNode() = default;

}  // namespace polygonal_perception::openni2_ros

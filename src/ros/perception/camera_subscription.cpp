#include "ros/perception/camera_subscription.hpp"

#include <ros/names.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

#include <exception>
#include <stdexcept>
#include <utility>

#include "ros/perception/topics.hpp"

namespace polygonal_perception::ros_perception {

CameraSubscription::CameraSubscription(const ros::NodeHandle& handle, const std::string& node,
                                       const std::string& input,
                                       std::shared_ptr<ros_common::CallbackGate> gate, Actions actions)
    : handle_(handle),
      namespace_(ros::names::parentNamespace(node)),
      depth_(input == "depth"),
      gate_(std::move(gate)),
      actions_(std::move(actions))
{
}

template <class Message, class Action>
ros::Subscriber CameraSubscription::subscribe(const char* topic, Action action)
{
  // In full: a nodelet of the root namespace in a manager of another one has a handle whose relative names
  // fall into the manager's namespace, past the nodelet's remappings.
  const std::string name = ros::names::append(namespace_, topic);
  try {
    return handle_.subscribe<Message>(name, topics::kInputQueueSize, ros_common::gated(gate_, action),
                                      nullptr, ros::TransportHints().tcpNoDelay());
  } catch (const std::exception& error) {
    throw std::runtime_error(handle_.resolveName(name) + ": " + error.what());
  }
}

CameraSubscription::Ended CameraSubscription::start()
{
  // roscpp throws where somebody in this process reads the same topic as another type; out of a callback that
  // would take the manager down.
  try {
    if (depth_) {
      camera_info_ = subscribe<sensor_msgs::CameraInfo>(
          topics::kCameraInfo,
          [this](const sensor_msgs::CameraInfoConstPtr& info) { actions_.camera_info(info); });
      frames_ =
          subscribe<sensor_msgs::Image>(topics::kDepthImage, [this](const sensor_msgs::ImageConstPtr& image) {
            take(image, {nullptr, image});
          });
    } else {
      frames_ = subscribe<sensor_msgs::PointCloud2>(topics::kPoints,
                                                    [this](const sensor_msgs::PointCloud2ConstPtr& cloud) {
                                                      take(cloud, {cloud, nullptr});
                                                    });
    }
  } catch (const std::exception& error) {
    Ended ended = stop();
    error_ = error.what();
    return ended;
  }
  error_.clear();
  return {};
}

CameraSubscription::Ended CameraSubscription::stop()
{
  error_.clear();
  return {std::exchange(frames_, {}), std::exchange(camera_info_, {})};
}

void CameraSubscription::take(const boost::shared_ptr<const void>& message, const InputFrame& frame)
{
  // roscpp connects a publisher of the same process twice when it advertises while we subscribe, and then
  // hands over each message twice.
  if (!message.owner_before(last_message_) && !last_message_.owner_before(message)) return;
  last_message_ = message;
  actions_.frame(frame);
}

}  // namespace polygonal_perception::ros_perception

#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <sensor_msgs/CameraInfo.h>

#include <boost/shared_ptr.hpp>
#include <boost/weak_ptr.hpp>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "polygonal_perception/ros/common/callback_gate.hpp"
#include "ros/perception/input_frame.hpp"

namespace polygonal_perception::ros_perception {

/// The camera's topics: a cloud, or a depth image with its camera_info. Hands over each message once,
/// uncopied.
class CameraSubscription
{
public:
  /// What to do with what comes; called inside the gate.
  struct Actions
  {
    std::function<void(const InputFrame&)> frame;
    std::function<void(const sensor_msgs::CameraInfoConstPtr&)> camera_info;
  };

  /// Subscriptions that are over. To be destroyed outside of the gate: roscpp then waits for a callback that
  /// is under way, which may be waiting to come in.
  using Ended = std::vector<ros::Subscriber>;

  /// @param handle  whose queue serves the callbacks
  /// @param node    the node's name; its inputs are beside it
  /// @param input   "cloud" or "depth"
  CameraSubscription(const ros::NodeHandle& handle, const std::string& node, const std::string& input,
                     std::shared_ptr<ros_common::CallbackGate> gate, Actions actions);

  /// Begins; where it cannot, error() says why.
  Ended start();
  Ended stop();

  bool active() const { return static_cast<bool>(frames_); }
  /// Why start() failed, or empty.
  const std::string& error() const { return error_; }
  /// Where frames come from, with the node's remappings; empty while it is not active.
  std::string topic() const { return frames_.getTopic(); }
  bool isPublished() const { return frames_.getNumPublishers() > 0; }

private:
  template <class Message, class Action>
  ros::Subscriber subscribe(const char* topic, Action action);
  void take(const boost::shared_ptr<const void>& message, const InputFrame& frame);

  ros::NodeHandle handle_;
  std::string namespace_;
  bool depth_;
  std::shared_ptr<ros_common::CallbackGate> gate_;
  Actions actions_;
  ros::Subscriber frames_;
  ros::Subscriber camera_info_;
  boost::weak_ptr<const void> last_message_;
  std::string error_;
};

}  // namespace polygonal_perception::ros_perception

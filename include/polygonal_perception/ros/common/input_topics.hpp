#pragma once

#include <ros/names.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <sensor_msgs/Image.h>

#include <boost/shared_ptr.hpp>
#include <boost/weak_ptr.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/ros/common/callback_gate.hpp"

namespace polygonal_perception::ros_common {

/// A node's input topics, subscribed and left together, as a lazy node does with its readers. Messages are
/// handed over uncopied, and only the newest: one that waited is dropped for it.
class POLYGONAL_PERCEPTION_EXPORT InputTopics
{
public:
  /// Ends with its last copy.
  struct Subscription
  {
    std::shared_ptr<void> subscriber;
    std::string topic;                          ///< with the node's remappings
    std::string type;                           ///< that it wants, in the master's spelling
    std::function<std::uint32_t()> publishers;  ///< how many it has
  };
  /// Subscriptions that are over. To be destroyed outside of the gate: roscpp then waits for a callback that
  /// is under way, which may be waiting to come in.
  using Unsubscribed = std::vector<Subscription>;

  /// @param handle  whose queue serves the callbacks
  /// @param node    the node's name; its inputs are beside it
  /// @param gate    callbacks run inside it
  InputTopics(const ros::NodeHandle& handle, const std::string& node, std::shared_ptr<CallbackGate> gate);

  InputTopics(const InputTopics&) = delete;
  InputTopics& operator=(const InputTopics&) = delete;

  /// Adds a topic, before the first subscription. The first one is what the node waits for: it is subscribed
  /// last, and none of its messages is handed over twice.
  template <class Message>
  void add(const char* topic, std::function<void(const boost::shared_ptr<const Message>&)> action)
  {
    // In full: a nodelet of the root namespace in a manager of another one has a handle whose relative names
    // fall into the manager's namespace, past the nodelet's remappings.
    const std::string name = ros::names::append(namespace_, topic);
    const bool is_first = topics_.empty();
    topics_.push_back(
        {name, [this, name, is_first, action = std::move(action)] {
           const auto last = std::make_shared<boost::weak_ptr<const void>>();
           const auto take = [last, is_first, action](const boost::shared_ptr<const Message>& message) {
             if (!is_first || isNew(message, *last)) action(message);
           };
           const auto subscriber = std::make_shared<ros::Subscriber>(handle_.subscribe<Message>(
               name, kQueueSize, gated(gate_, take), nullptr, ros::TransportHints().tcpNoDelay()));
           return Subscription{subscriber, subscriber->getTopic(), ros::message_traits::datatype<Message>(),
                               [subscriber] { return subscriber->getNumPublishers(); }};
         }});
  }

  /// The same for images that come by a transport of image_transport: raw, compressedDepth or another whose plugin
  /// is installed. Raw ones are handed over uncopied.
  void addImage(const char* topic, const std::string& transport,
                std::function<void(const sensor_msgs::ImageConstPtr&)> action);

  /// Called when the topics are about to be subscribed, and when they have been left.
  void onChange(std::function<void()> starting, std::function<void()> stopped)
  {
    starting_ = std::move(starting);
    stopped_ = std::move(stopped);
  }

  /// Subscribes if that is wanted, and leaves if not; where it cannot subscribe, error() says why.
  Unsubscribed setSubscribed(bool wanted);

  /// A topic's name in full, with the node's remappings.
  std::string resolvedName(const char* topic) const
  {
    return handle_.resolveName(ros::names::append(namespace_, topic));
  }

  bool active() const { return !subscribers_.empty(); }
  /// Why it could not subscribe, or empty.
  const std::string& error() const { return error_; }
  /// The first topic's name, with the node's remappings; empty while it is not active.
  std::string topic() const { return active() ? subscribers_.back().topic : std::string(); }
  bool isPublished() const { return active() && subscribers_.back().publishers() > 0; }
  /// As what another type the first topic is published, or empty: then nothing arrives.
  std::string otherType() const;

private:
  static constexpr std::uint32_t kQueueSize = 1;

  struct Topic
  {
    std::string name;
    std::function<Subscription()> subscribe;
  };

  Unsubscribed start();
  static bool isNew(const boost::shared_ptr<const void>& message, boost::weak_ptr<const void>& last);

  ros::NodeHandle handle_;
  std::string node_;
  std::string namespace_;
  std::shared_ptr<CallbackGate> gate_;
  std::vector<Topic> topics_;
  std::function<void()> starting_ = [] {};
  std::function<void()> stopped_ = [] {};
  std::vector<Subscription> subscribers_;
  std::string error_;
};

/// A callback that runs `update` inside the gate and ends the subscriptions that it returns outside of it.
template <class Update>
auto unsubscribingOutside(const std::shared_ptr<CallbackGate>& gate, Update update)
{
  return [gate, update](const auto&...) {
    InputTopics::Unsubscribed unsubscribed;
    const auto inside = gate->enter();
    if (inside.owns_lock()) unsubscribed = update();
  };
}

}  // namespace polygonal_perception::ros_common

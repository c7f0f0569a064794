#include "polygonal_perception/ros/common/input_topics.hpp"

#include <image_transport/image_transport.h>

#include <exception>
#include <utility>

#include "polygonal_perception/ros/common/published_type.hpp"

namespace polygonal_perception::ros_common {

InputTopics::InputTopics(const ros::NodeHandle& handle, const std::string& node,
                         std::shared_ptr<CallbackGate> gate)
    : handle_(handle), node_(node), namespace_(ros::names::parentNamespace(node)), gate_(std::move(gate))
{
}

void InputTopics::addImage(const char* topic, const std::string& transport,
                           std::function<void(const sensor_msgs::ImageConstPtr&)> action)
{
  if (transport == "raw") {
    add<sensor_msgs::Image>(topic, std::move(action));
    return;
  }
  const std::string name = ros::names::append(namespace_, topic);
  topics_.push_back({name, [this, name, transport, action = std::move(action)] {
                       // image_transport appends the transport's name, to which no remapping applies.
                       const std::string base = handle_.resolveName(name);
                       const image_transport::TransportHints hints(
                           transport, ros::TransportHints().tcpNoDelay(), ros::NodeHandle(node_));
                       const boost::function<void(const sensor_msgs::ImageConstPtr&)> take =
                           gated(gate_, action);
                       const auto subscriber = std::make_shared<image_transport::Subscriber>(
                           image_transport::ImageTransport(handle_).subscribe(base, kQueueSize, take,
                                                                              ros::VoidPtr(), hints));
                       return Subscription{subscriber, base + "/" + transport, "",
                                           [subscriber] { return subscriber->getNumPublishers(); }};
                     }});
}

std::string InputTopics::otherType() const
{
  if (!active() || subscribers_.back().type.empty()) return {};
  const std::string type = publishedType(subscribers_.back().topic);
  return type == subscribers_.back().type ? std::string() : type;
}

InputTopics::Unsubscribed InputTopics::setSubscribed(bool wanted)
{
  if (wanted && active()) return {};
  if (wanted) {
    starting_();
    return start();
  }
  error_.clear();
  stopped_();
  return std::exchange(subscribers_, {});
}

InputTopics::Unsubscribed InputTopics::start()
{
  error_.clear();
  for (auto topic = topics_.rbegin(); topic != topics_.rend(); ++topic) {
    // roscpp throws where somebody in this process reads the same topic as another type; out of a callback
    // that would take the manager down.
    try {
      subscribers_.push_back(topic->subscribe());
    } catch (const std::exception& error) {
      error_ = handle_.resolveName(topic->name) + ": " + error.what();
      return std::exchange(subscribers_, {});
    }
  }
  return {};
}

/// roscpp connects a publisher of the same process twice when it advertises while we subscribe, and then
/// hands over each message twice.
bool InputTopics::isNew(const boost::shared_ptr<const void>& message, boost::weak_ptr<const void>& last)
{
  if (!message.owner_before(last) && !last.owner_before(message)) return false;
  last = message;
  return true;
}

}  // namespace polygonal_perception::ros_common

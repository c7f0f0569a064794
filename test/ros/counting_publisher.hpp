#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <ros/topic_manager.h>

#include <string>

namespace polygonal_perception::test {

/// Serves callbacks until something holds, but not for ever.
template <class Condition>
bool waitFor(Condition&& condition)
{
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(20.0);
  while (!condition()) {
    if (!ros::ok() || ros::WallTime::now() > deadline) return false;
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
  }
  return true;
}

/// Publishes as ros::Publisher does, and counts how often the message had to be serialised for that.
template <class Message>
class CountingPublisher
{
public:
  explicit CountingPublisher(const std::string& topic)
      : publisher_(ros::NodeHandle().advertise<Message>(topic, 1))
  {
  }

  void publish(const boost::shared_ptr<Message>& message)
  {
    ros::SerializedMessage serialized;
    serialized.type_info = &typeid(Message);
    serialized.message = message;
    const auto serialize = [&] {
      ++serialisations_;
      return ros::serialization::serializeMessage(*message);
    };
    ros::TopicManager::instance()->publish(publisher_.getTopic(), serialize, serialized);
  }

  std::uint32_t readers() const { return publisher_.getNumSubscribers(); }
  int serialisations() const { return serialisations_; }

private:
  ros::Publisher publisher_;
  int serialisations_ = 0;
};

}  // namespace polygonal_perception::test

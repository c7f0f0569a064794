#include "polygonal_perception/ros/common/input_topics.hpp"

#include <exception>
#include <utility>

namespace polygonal_perception::ros_common {

InputTopics::InputTopics(const ros::NodeHandle& handle, const std::string& node,
                         std::shared_ptr<CallbackGate> gate)
    : handle_(handle), namespace_(ros::names::parentNamespace(node)), gate_(std::move(gate))
{
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

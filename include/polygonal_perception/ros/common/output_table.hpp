#pragma once

#include <image_transport/image_transport.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <boost/shared_ptr.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace polygonal_perception::ros_common {

/// For a node of which nothing is left out for want of a reader but the messages themselves.
struct NoNeeds
{
  NoNeeds& operator|=(const NoNeeds& /*other*/) { return *this; }
};

/// A node's output topics as a table: the topic, what it is made of, how its message is built. A message is
/// built only while somebody reads it, anew for each result: readers in the same process share it, and nobody
/// touches it again.
///
/// @tparam Result  what messages are built from
/// @tparam Needs   a set of products of the computation, with |=; what nobody reads need not be computed
template <class Result, class Needs>
class OutputTable
{
public:
  static constexpr std::uint32_t kQueueSize = 2;

  /// @param private_handle   where the topics are
  /// @param readers_changed  called from the handle's queue when a reader has come or gone
  OutputTable(const ros::NodeHandle& private_handle, std::function<void()> readers_changed)
      : handle_(private_handle), readers_changed_(std::move(readers_changed))
  {
  }
  ~OutputTable() { shutdown(); }
  OutputTable(const OutputTable&) = delete;
  OutputTable& operator=(const OutputTable&) = delete;

  /// @param build  the message, or nothing where the result has not what it takes
  template <class Message>
  void add(const char* topic, Needs needs, std::function<boost::shared_ptr<Message>(const Result&)> build)
  {
    const ros::SubscriberStatusCallback status = [changed = readers_changed_](const auto& /*reader*/) {
      changed();
    };
    add(handle_.advertise<Message>(topic, kQueueSize, status, status), needs, std::move(build));
  }

  /// The same for an image, with all the transports that are installed.
  void addImage(const char* topic, Needs needs,
                std::function<boost::shared_ptr<sensor_msgs::Image>(const Result&)> build)
  {
    const image_transport::SubscriberStatusCallback status =
        [changed = readers_changed_](const auto& /*reader*/) { changed(); };
    add(image_transport::ImageTransport(handle_).advertise(topic, kQueueSize, status, status), needs,
        std::move(build));
  }

  bool hasReaders() const
  {
    for (const Output& output : outputs_) {
      if (output.isRead()) return true;
    }
    return false;
  }

  /// What has to be computed for those who read now.
  Needs needs() const
  {
    Needs needs{};
    for (const Output& output : outputs_) {
      if (output.isRead()) needs |= output.needs;
    }
    return needs;
  }

  void publish(const Result& result) const
  {
    for (const Output& output : outputs_) {
      if (output.isRead()) output.publish(result);
    }
  }

  /// Ends all topics and waits for callbacks under way.
  void shutdown()
  {
    for (Output& output : outputs_) output.shutdown();
  }

private:
  struct Output
  {
    Needs needs;
    std::function<bool()> isRead;
    std::function<void(const Result&)> publish;
    std::function<void()> shutdown;
  };

  template <class Publisher, class Build>
  void add(Publisher publisher, Needs needs, Build build)
  {
    // Publishers are handles: these three share one.
    const auto shared = std::make_shared<Publisher>(std::move(publisher));
    outputs_.push_back({needs, [shared] { return shared->getNumSubscribers() > 0; },
                        [shared, build](const Result& result) {
                          if (const auto message = build(result)) shared->publish(message);
                        },
                        [shared] { shared->shutdown(); }});
  }

  ros::NodeHandle handle_;
  std::function<void()> readers_changed_;
  std::vector<Output> outputs_;
};

}  // namespace polygonal_perception::ros_common

#pragma once

#include <ros/node_handle.h>

#include <memory>
#include <string>
#include <utility>

#include "polygonal_perception/ros/common/callback_gate.hpp"
#include "polygonal_perception/ros/common/frame_statistics.hpp"
#include "polygonal_perception/ros/common/input_topics.hpp"
#include "polygonal_perception/ros/common/parameter_holder.hpp"
#include "polygonal_perception/ros/common/throttled_log.hpp"

namespace polygonal_perception::ros_common {

/// What every node stands on: its handles, its parameters in force, its log, its input topics, what became of
/// its input, and the gate that its callbacks go through.
///
/// A node holds it as its first member, makes all that callbacks use by core_.make(), and begins its
/// destructor with core_.close().
///
/// The handles' queue may be served by any thread, one callback at a time, as a nodelet's single-threaded
/// queue is.
template <class Parameters>
struct NodeCore
{
  NodeCore(const ros::NodeHandle& node_handle, const ros::NodeHandle& node_private_handle,
           FrameStatistics frames)
      : handle(node_handle),
        private_handle(node_private_handle),
        name(node_private_handle.getNamespace()),
        parameters(node_private_handle),
        log(name),
        statistics(std::move(frames)),
        inputs(node_handle, name, gate)
  {
  }

  /// Makes what callbacks use: none comes in before all of it stands, nor ever if that fails.
  /// @param make  may throw; returns subscriptions that are over
  template <class Make>
  void make(Make&& make)
  {
    InputTopics::Unsubscribed unsubscribed;  // ends outside of the gate
    const auto inside = gate->enter();
    try {
      unsubscribed = make();
    } catch (...) {
      gate->closeInside();
      throw;
    }
  }

  /// Waits for the callback that is under way; after this none runs.
  void close()
  {
    gate->close();
    parameters.shutdown();
  }

  /// Subscribes to the inputs if that is wanted, leaves them if not, and says in the log why it cannot.
  /// @return to be destroyed outside of the gate
  InputTopics::Unsubscribed setSubscribed(bool wanted)
  {
    InputTopics::Unsubscribed unsubscribed = inputs.setSubscribed(wanted);
    if (!inputs.error().empty()) log.error("subscription", "cannot subscribe to " + inputs.error());
    return unsubscribed;
  }

  std::shared_ptr<CallbackGate> gate = std::make_shared<CallbackGate>();
  ros::NodeHandle handle;
  ros::NodeHandle private_handle;
  const std::string name;
  ParameterHolder<Parameters> parameters;
  ThrottledLog log;
  FrameStatistics statistics;
  InputTopics inputs;
};

}  // namespace polygonal_perception::ros_common

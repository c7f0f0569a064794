#pragma once

#include <tf2_msgs/TFMessage.h>

#include <chrono>
#include <optional>
#include <set>
#include <string>

namespace polygonal_perception::ros_perception {

/// Watches tf for somebody else who broadcasts the floor frame: the node of another camera that has the same
/// `floor_frame`, or a robot's model. A frame has one parent in tf: with two of them, what is placed in it jumps about.
///
/// Of two nodes the one that came later is silent, or if both began at once the one whose camera's name comes later.
class FloorFrameGuard
{
public:
  using Clock = std::chrono::steady_clock;

  explicit FloorFrameGuard(std::string floor_frame) : floor_frame_(std::move(floor_frame)) {}

  /// Takes a message of tf.
  /// @param is_static  as /tf_static has them: it holds until the end
  void see(const tf2_msgs::TFMessage& message, const std::string& publisher, bool is_static,
           Clock::time_point now);

  /// @param parent  the input's frame
  /// @return why the floor must not be broadcast below it, or nothing
  std::string conflict(const std::string& parent, Clock::time_point now);

  /// The floor is broadcast below this frame now.
  void broadcast(const std::string& parent)
  {
    own_parents_.insert(parent);
    is_broadcasting_ = true;
  }

private:
  struct Other
  {
    std::string parent;
    std::string publisher;
    bool is_static = false;
    Clock::time_point seen;
  };

  std::string floor_frame_;
  std::set<std::string> own_parents_;  // also of before: what was sent may come back late
  bool is_broadcasting_ = false;
  std::optional<Other> other_;
};

}  // namespace polygonal_perception::ros_perception

#include "ros/perception/floor_frame_guard.hpp"

namespace polygonal_perception::ros_perception {

namespace {

/// A node that has not broadcast for so long has ended, or sees nothing.
constexpr std::chrono::seconds kForgotten(2);

}  // namespace

void FloorFrameGuard::see(const tf2_msgs::TFMessage& message, const std::string& publisher, bool is_static,
                          Clock::time_point now)
{
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    if (transform.child_frame_id != floor_frame_ || own_parents_.count(transform.header.frame_id) > 0)
      continue;
    other_ = Other{transform.header.frame_id, publisher, is_static, now};
  }
}

std::string FloorFrameGuard::conflict(const std::string& parent, Clock::time_point now)
{
  if (!other_ || other_->parent == parent) return {};
  if (!other_->is_static && now - other_->seen > kForgotten) return {};
  const bool was_first = is_broadcasting_ && parent < other_->parent;
  if (was_first && !other_->is_static) return {};
  is_broadcasting_ = false;
  return "floor_frame '" + floor_frame_ + "' is already broadcast below '" + other_->parent + "', by " +
         other_->publisher + "; each camera needs a floor_frame of its own";
}

}  // namespace polygonal_perception::ros_perception

#include "polygonal_perception/ros/common/throttled_log.hpp"

#include <ros/console.h>

namespace polygonal_perception::ros_common {

void ThrottledLog::error(const std::string& kind, const std::string& text)
{
  if (due(kind)) ROS_ERROR_STREAM("[" << name_ << "] " << text);
}

void ThrottledLog::warn(const std::string& kind, const std::string& text)
{
  if (due(kind)) ROS_WARN_STREAM("[" << name_ << "] " << text);
}

bool ThrottledLog::due(const std::string& kind)
{
  constexpr std::chrono::seconds kPeriod(2);
  const auto now = std::chrono::steady_clock::now();
  const auto [entry, is_new] = last_.try_emplace(kind, now);
  if (!is_new && now - entry->second < kPeriod) return false;
  entry->second = now;
  return true;
}

}  // namespace polygonal_perception::ros_common

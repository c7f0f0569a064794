#include "polygonal_perception/ros/common/throttled_log.hpp"

#include <ros/console.h>

namespace polygonal_perception::ros_common {

std::string shortened(const std::string& text)
{
  constexpr std::size_t kLongest = 1000;
  constexpr std::size_t kEnd = 300;
  if (text.size() <= kLongest) return text;
  return text.substr(0, kLongest - kEnd) + " [" + std::to_string(text.size() - kLongest) +
         " bytes left out] " + text.substr(text.size() - kEnd);
}

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

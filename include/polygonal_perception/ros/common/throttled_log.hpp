#pragma once

#include <chrono>
#include <map>
#include <string>

#include "polygonal_perception/export.hpp"

namespace polygonal_perception::ros_common {

/// A frame_id or an encoding may have megabytes, which would go into each report: of a long text the begin and the end,
/// which has what is accepted.
POLYGONAL_PERCEPTION_EXPORT std::string shortened(const std::string& text);

/// Says what is wrong, but not thirty times a second: each kind of complaint at most every few seconds.
///
/// Unlike ROS_ERROR_THROTTLE it works by the wall clock, since simulated time may stand still or jump back,
/// and apart for every nodelet of a manager.
class POLYGONAL_PERCEPTION_EXPORT ThrottledLog
{
public:
  /// @param name  of the node or nodelet, which begins each text
  explicit ThrottledLog(std::string name) : name_(std::move(name)) {}

  /// @param kind  one of a few constants
  void error(const std::string& kind, const std::string& text);
  void warn(const std::string& kind, const std::string& text);

private:
  bool due(const std::string& kind);

  std::string name_;
  std::map<std::string, std::chrono::steady_clock::time_point> last_;
};

}  // namespace polygonal_perception::ros_common

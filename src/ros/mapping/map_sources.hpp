#pragma once

#include <polygonal_perception/ObservedCells.h>
#include <ros/time.h>

#include <Eigen/Geometry>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "polygonal_perception/ros/common/stamp_order.hpp"

namespace polygonal_perception::ros_mapping {

/// What is known of each sensor that a map is made from: whether it is silent, late or without a floor, and where its
/// floor lies.
class MapSources
{
public:
  using Clock = std::chrono::steady_clock;

  explicit MapSources(const std::vector<std::string>& names);

  /// Whether an observation of that stamp means that time has jumped back: everything before is of another time.
  bool jumpsBack(std::size_t source, const ros::Time& stamp)
  {
    return sources_[source].stamps.jumpsBack(stamp);
  }

  /// Notes an observation that has come in.
  /// @param max_delay  [s] by which it may be older than the newest one
  /// @return whether it may clear: its floor was found, and it is not late
  bool mayClear(std::size_t source, const ros::Time& stamp, std::uint8_t floor_status, double max_delay,
                Clock::time_point now);

  /// @param grid_to_fixed  where tf says that the floor of a source lies; nothing: its cells came in the fixed frame
  void setFloor(std::size_t source, const std::optional<Eigen::Isometry3d>& grid_to_fixed);

  /// Forgets all stamps.
  void reset();

  /// What is wrong with a source now, or empty.
  std::string complaint(std::size_t source, Clock::time_point now) const;
  /// Which two sources have floors that do not lie in one plane, and by how much; or empty.
  std::string disagreement() const;

  std::size_t size() const { return sources_.size(); }
  const std::string& name(std::size_t source) const { return sources_[source].name; }

private:
  struct Source
  {
    std::string name;
    ros_common::StampOrder stamps;
    std::optional<Clock::time_point> last_arrival;
    std::uint8_t floor_status = 0;
    bool is_late = false;
    std::optional<Eigen::Vector3d> floor_up;  // in the fixed frame
    double floor_height = 0.0;                // [m]
  };

  std::vector<Source> sources_;
  ros::Time newest_;
};

}  // namespace polygonal_perception::ros_mapping

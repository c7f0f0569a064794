#include "plugins/dense_plan.hpp"

#include <algorithm>
#include <cmath>

namespace polygonal_perception::plugins {

std::vector<geometry_msgs::PoseStamped> densePlan(const std::vector<Eigen::Vector2d>& corners,
                                                  const Eigen::Isometry3d& to_frame, double spacing,
                                                  const std::optional<double>& goal_yaw,
                                                  const std_msgs::Header& header)
{
  std::vector<geometry_msgs::PoseStamped> plan;
  const auto append = [&](const Eigen::Vector2d& place, double yaw) {
    const Eigen::Vector3d position = to_frame * Eigen::Vector3d(place.x(), place.y(), 0.0);
    const Eigen::Vector3d ahead = to_frame.linear() * Eigen::Vector3d(std::cos(yaw), std::sin(yaw), 0.0);
    const double half = std::atan2(ahead.y(), ahead.x()) / 2.0;
    geometry_msgs::PoseStamped pose;
    pose.header = header;
    pose.pose.position.x = position.x();
    pose.pose.position.y = position.y();
    pose.pose.orientation.z = std::sin(half);
    pose.pose.orientation.w = std::cos(half);
    plan.push_back(pose);
  };
  double yaw = 0.0;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const Eigen::Vector2d along = corners[i + 1] - corners[i];
    if (!along.isZero(0.0)) yaw = std::atan2(along.y(), along.x());
    const double pieces = std::max(1.0, std::ceil(along.norm() / spacing));
    for (double piece = 0.0; piece < pieces; ++piece) append(corners[i] + piece / pieces * along, yaw);
  }
  append(corners.back(), goal_yaw.value_or(yaw));
  return plan;
}

}  // namespace polygonal_perception::plugins

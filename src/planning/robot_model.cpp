#include "polygonal_perception/planning/robot_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polygonal_perception::planning {

namespace {

double approach(double value, double wanted, double most)
{
  return value + std::clamp(wanted - value, -most, most);
}

double stoppingTime(double speed, double limit)
{
  if (speed == 0.0) return 0.0;
  return limit > 0.0 ? std::abs(speed) / limit : std::numeric_limits<double>::infinity();
}

}  // namespace

Twist RobotModel::clamped(const Twist& twist) const
{
  return {std::clamp(twist.x, min_vel_x, max_vel_x), std::clamp(twist.y, min_vel_y, max_vel_y),
          std::clamp(twist.theta, -max_vel_theta, max_vel_theta)};
}

Twist RobotModel::follow(const Twist& velocity, const Twist& command, double duration) const
{
  return {approach(velocity.x, command.x, acc_lim_x * duration),
          approach(velocity.y, command.y, acc_lim_y * duration),
          approach(velocity.theta, command.theta, acc_lim_theta * duration)};
}

RobotState RobotModel::advanced(const RobotState& state, const Twist& command, double duration) const
{
  const Twist velocity = follow(state.velocity, command, duration);
  return {Arc(state.pose, velocity).pose(duration), velocity};
}

double RobotModel::brakingTime(const Twist& velocity) const
{
  return std::max({stoppingTime(velocity.x, acc_lim_x), stoppingTime(velocity.y, acc_lim_y),
                   stoppingTime(velocity.theta, acc_lim_theta)});
}

}  // namespace polygonal_perception::planning

#pragma once

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/parameters/parameter_table.hpp"
#include "polygonal_perception/planning/arc.hpp"

namespace polygonal_perception::planning {

/// Where a robot is, and how fast it moves.
struct RobotState
{
  Pose pose;
  Twist velocity;
};

/// What a wheeled robot's base does with a command: each component of its velocity follows it as fast as its acceleration
/// limit lets it. Differential robots have a max_vel_y of 0. Names are those of dwa_local_planner.
struct POLYGONAL_PERCEPTION_EXPORT RobotModel
{
  double max_vel_x = 0.55;     ///< [m/s]
  double min_vel_x = 0.0;      ///< [m/s] below 0: it may drive backwards
  double max_vel_y = 0.0;      ///< [m/s]
  double min_vel_y = 0.0;      ///< [m/s]
  double max_vel_theta = 1.0;  ///< [rad/s]
  double acc_lim_x = 2.5;      ///< [m/s^2]
  double acc_lim_y = 2.5;      ///< [m/s^2]
  double acc_lim_theta = 3.2;  ///< [rad/s^2]

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor&& visit)
  {
    using parameters::Range;
    visit("max_vel_x", self.max_vel_x, Range{0.0, 20.0}, "m/s", "The fastest that the robot drives ahead.");
    visit("min_vel_x", self.min_vel_x, Range{-20.0, 0.0}, "m/s",
          "The fastest that it drives backwards, below 0; 0: it does not.");
    visit("max_vel_y", self.max_vel_y, Range{0.0, 20.0}, "m/s",
          "The fastest that an omnidirectional robot drives to the left; 0: it cannot.");
    visit("min_vel_y", self.min_vel_y, Range{-20.0, 0.0}, "m/s", "The same to the right, below 0.");
    visit("max_vel_theta", self.max_vel_theta, Range{0.0, 20.0}, "rad/s", "The fastest that it turns.");
    visit("acc_lim_x", self.acc_lim_x, Range{0.01, 100.0}, "m/s^2",
          "How fast its velocity ahead may change.");
    visit("acc_lim_y", self.acc_lim_y, Range{0.0, 100.0}, "m/s^2",
          "How fast its velocity to the side may change.");
    visit("acc_lim_theta", self.acc_lim_theta, Range{0.01, 100.0}, "rad/s^2",
          "How fast its turning rate may change.");
  }

  /// The nearest velocity within its limits.
  Twist clamped(const Twist& twist) const;
  /// The velocity after some time [s] under a command within its limits.
  Twist follow(const Twist& velocity, const Twist& command, double duration) const;
  /// The robot after a short time [s] under a command: it moves with the velocity that it has at the end.
  RobotState advanced(const RobotState& state, const Twist& command, double duration) const;
  /// [s] it takes to stop, all components becoming smaller in the same proportion.
  double brakingTime(const Twist& velocity) const;
};

}  // namespace polygonal_perception::planning

#pragma once

#include "polygonal_perception/parameters/parameter_table.hpp"
#include "polygonal_perception/planning/robot_model.hpp"

namespace polygonal_perception::planning {

/// How a robot follows a path. Names are those of dwa_local_planner.
struct DrivingParameters
{
  RobotModel robot;
  double sim_time = 1.7;  ///< [s]
  int vx_samples = 6;
  int vy_samples = 5;
  int vth_samples = 20;
  double xy_goal_tolerance = 0.1;    ///< [m]
  double yaw_goal_tolerance = 0.05;  ///< [rad]
  // Figures are of a fast robot in 100 of BARN's worlds, driven by this library alone; the script for them is still to come.
  /// [m] A corner of the path that is nearer says nothing about where to head for, but farther points lie behind corners: with
  /// 0.1 two robots got stuck, with 0.325 eight.
  double heading_lookahead = 0.02;
  /// How much more what is left of the way counts than the time that a motion takes. With 1 standing is as good as driving
  /// there: with 1.1 58 robots did not start or got stuck. With 4 one got stuck, and the others took 4 % longer.
  double progress_scale = 2.0;
  /// [s] What it costs to change a velocity by its limit. With 0 they took 1 % longer.
  double smoothness_scale = 0.1;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor&& visit)
  {
    using parameters::Range;
    RobotModel::describe(self.robot, visit);
    visit("sim_time", self.sim_time, Range{0.1, 10.0}, "s", "How far ahead motions are looked at.");
    visit("vx_samples", self.vx_samples, Range{2, 100}, "", "How many velocities ahead are tried.");
    visit("vy_samples", self.vy_samples, Range{1, 100}, "",
          "How many velocities to the side, of a robot that has them.");
    visit("vth_samples", self.vth_samples, Range{2, 100}, "", "How many turning rates.");
    visit("xy_goal_tolerance", self.xy_goal_tolerance, Range{0.001, 10.0}, "m",
          "The goal is reached where it is no farther away.");
    visit("yaw_goal_tolerance", self.yaw_goal_tolerance, Range{0.001, 6.3}, "rad",
          "The goal's yaw is reached within this.");
    visit("heading_lookahead", self.heading_lookahead, Range{0.0, 10.0}, "m",
          "The robot is to head for a point of its path that is so far ahead.");
    visit("progress_scale", self.progress_scale, Range{1.0, 100.0}, "",
          "How much more what is left of the way counts than the time that a motion takes.");
    visit("smoothness_scale", self.smoothness_scale, Range{0.0, 10.0}, "s",
          "What it costs to change a velocity by its limit.");
  }
};

}  // namespace polygonal_perception::planning

#pragma once

#include "polygonal_perception/parameters/parameter_table.hpp"

namespace polygonal_perception::perception {

/// What decides which plane is the floor: a sum of terms in nats (natural logarithms of odds, so that 1 is a factor
/// of 2.7 and 3 one of 20). What each is worth is measured in doc/floor_ablation.md.
struct FloorSelectionParameters
{
  /// Bounds: they rule planes out, and speak for none.
  double max_tilt = 0.78539816339744831;  ///< [rad] pi/4 (eq. 3), from the up vector
  double min_camera_height = 0.05;        ///< [m]
  double max_camera_height = 3.0;         ///< [m]
  /// [rad] A plane so far from what tf calls level is no floor, whatever it looks like: the frame_id is wrong, or tf. Robots
  /// that climb do not tilt so far.
  double farthest_from_level = 1.0471975511965976;
  /// [rad] A seed is a rough guess of the camera's attitude, and max_tilt is wider by this about it.
  double seed_slack = 0.15;
  /// [rad] By how much a floor's normal may be off the up vector.
  double maxTilt(bool up_is_measured) const { return max_tilt + (up_is_measured ? 0.0 : seed_slack); }

  /// Support: ln(number of its samples), so that ten times the samples speak for it by 2.3.

  /// [rad] Tilt: a floor's angle from the up vector is normally distributed, so widely about a seed, and about an up
  /// vector that was measured.
  double tilt_about_seed = 0.32;
  double tilt_about_measured = 0.12;

  /// Scatter: samples below it that lie on no level plane speak against it, by this times
  /// ln(1 + their number / (scatter_share * its samples)). A shiny floor has some; a wall has the room below it.
  double scatter = 2.0;
  double scatter_share = 0.25;
  double scatter_depth = 0.05;        ///< [m] so much lower counts,
  double scatter_depth_slope = 0.02;  ///< [m/m] and so much more for each metre of range

  /// Distance: a robot stands on what begins at its feet, so that a plane loses this times ln(metres to its begin).
  double distance = 1.0;

  /// Memory: what the last frames say of planes at its height.
  double confirmed = 20.0;      ///< where it has been for several frames: more than any drop in view
  double other_plane = 8.0;     ///< where another plane was seen beside that floor: a table, a lower storey
  double turn = 0.15;           ///< [rad] a camera that is moved by hand turns less than this between frames,
  double farthest_drop = 0.25;  ///< [m] and sinks less than this: a nearer plane is raised
  /// [m] Heights of other planes that differ by less are those of one; [rad] and they are as parallel as this.
  double same_offset = 0.1;
  double other_angle = 0.17;
  double least_offset = 0.15;  ///< [m] a nearer plane is not remembered: the floor itself may be as far off
  double least_share = 0.02;   ///< of the samples: a smaller plane would not be taken for the floor for long

  /// Steps: a step of a staircase that leads down out of the bounds is none, by so much.
  double step = 8.0;
  double least_rise = 0.1;  ///< [m]
  double most_rise = 0.25;  ///< [m]
  double same_rise = 0.03;  ///< [m] how much the rises of a staircase differ
  double step_angle = 0.1;  ///< [rad] and the tilts of its steps

  /// The floor is below: from plane to plane one goes down to another that is parallel, if the samples of the lower one
  /// below the higher one speak for it by lower_plane_weight * ln(1 + their number / lower_plane_unit).
  double lower_plane_weight = 3.0;
  double lower_plane_unit = 6.0;
  double parallel = 0.17;      ///< [rad]
  double clearly_below = 4.0;  ///< standard deviations

  /// And where a plane rises from a nearer one, the nearer one is the floor and the other a ramp, by so much.
  double nearer = 2.0;

  /// A plane with less in its favour than this is no floor: NOT_FOUND.
  double least_score = 0.5;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor&& visit)
  {
    visit("max_tilt", self.max_tilt, parameters::Range{0.01, 1.4}, "rad",
          "Largest angle between the up vector and the normal of a floor.");
    visit("min_camera_height", self.min_camera_height, parameters::Range{0.0, 10.0}, "m",
          "A plane less than this below the camera is no floor.");
    visit("max_camera_height", self.max_camera_height, parameters::Range{0.01, 20.0}, "m",
          "A plane more than this below the camera is no floor.");
    visit("lower_plane_weight", self.lower_plane_weight, parameters::Range{0.0, 100.0}, "",
          "How much a level plane below another one speaks for being the floor, in nats: three times as many "
          "of its "
          "samples seen below the other speak for it by about as much again.");
  }

  /// The rest, which users leave alone: for the ablation.
  template <class Self, class Visitor>
  static void describeThresholds(Self& self, Visitor&& visit)
  {
    visit("max_tilt", self.max_tilt);
    visit("farthest_from_level", self.farthest_from_level);
    visit("seed_slack", self.seed_slack);
    visit("tilt_about_seed", self.tilt_about_seed);
    visit("tilt_about_measured", self.tilt_about_measured);
    visit("scatter", self.scatter);
    visit("scatter_share", self.scatter_share);
    visit("scatter_depth", self.scatter_depth);
    visit("scatter_depth_slope", self.scatter_depth_slope);
    visit("distance", self.distance);
    visit("confirmed", self.confirmed);
    visit("other_plane", self.other_plane);
    visit("turn", self.turn);
    visit("farthest_drop", self.farthest_drop);
    visit("same_offset", self.same_offset);
    visit("other_angle", self.other_angle);
    visit("least_offset", self.least_offset);
    visit("least_share", self.least_share);
    visit("step", self.step);
    visit("least_rise", self.least_rise);
    visit("most_rise", self.most_rise);
    visit("same_rise", self.same_rise);
    visit("step_angle", self.step_angle);
    visit("lower_plane_weight", self.lower_plane_weight);
    visit("lower_plane_unit", self.lower_plane_unit);
    visit("parallel", self.parallel);
    visit("clearly_below", self.clearly_below);
    visit("nearer", self.nearer);
    visit("least_score", self.least_score);
  }
};

}  // namespace polygonal_perception::perception

#pragma once

#include <string>

#include "polygonal_perception/parameters/parameter_table.hpp"

namespace polygonal_perception::planning {

inline bool isOutsideRule(const std::string& text)
{
  return text == "free" || text == "blocked";
}

/// What a robot's paths may do, for whoever plans them.
struct PathParameters
{
  /// As far as polygons have grown by default (robot_radius): a goal at a wall becomes the nearest point before it.
  double goal_tolerance = 0.3;  ///< [m]
  std::string outside = "free";
  /// More than the lengths of two ways differ by from frame to frame, and little enough for nobody to mind the detour
  /// (doc/side_ablation.md): before a robot that stands it halves the jumps.
  double side_hysteresis = 0.1;

  bool outsideIsFree() const { return outside == "free"; }

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor&& visit)
  {
    using parameters::Range;
    visit("goal_tolerance", self.goal_tolerance, Range{0.0, 10.0}, "m",
          "How far from a goal that is inside an obstacle a path may end.");
    visit("outside", self.outside, parameters::TextRule{"free or blocked", isOutsideRule},
          "What lies beyond the polygons' extent, where nothing was looked at.");
    visit("side_hysteresis", self.side_hysteresis, Range{0.0, 1.0}, "share",
          "A path keeps to its side of each obstacle until one on another side is shorter by this share; "
          "with 0 each is the "
          "shortest.");
  }
};

}  // namespace polygonal_perception::planning

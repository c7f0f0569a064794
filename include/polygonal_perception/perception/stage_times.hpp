#pragma once

#include <chrono>

namespace polygonal_perception::perception {

/// How long each stage of a frame took; a stage that nobody asked for took nothing. A new timed stage is a
/// member and a line of describe(): the diagnostics take their names from there.
struct StageTimes
{
  using Duration = std::chrono::nanoseconds;

  Duration samples{0};
  Duration floor{0};
  Duration planes{0};
  Duration floor_hull{0};
  Duration ground{0};
  Duration projection{0};
  Duration scan{0};
  Duration looked_through{0};
  Duration obstacle_points{0};
  Duration inflation{0};
  Duration polygons{0};

  /// Calls visit(name, duration) for each stage, in the order in which they run.
  template <class Self, class Visitor>
  static void describe(Self& self, Visitor&& visit)
  {
    visit("samples", self.samples);
    visit("floor", self.floor);
    visit("planes", self.planes);
    visit("floor hull", self.floor_hull);
    visit("ground", self.ground);
    visit("projection", self.projection);
    visit("scan", self.scan);
    visit("looked through", self.looked_through);
    visit("obstacle points", self.obstacle_points);
    visit("inflation", self.inflation);
    visit("polygons", self.polygons);
  }
};

}  // namespace polygonal_perception::perception

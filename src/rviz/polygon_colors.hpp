#pragma once

#include <Eigen/Core>
#include <vector>

namespace polygonal_perception::displays {

/// A hue for each polygon. Messages do not number their polygons: one keeps its hue while its centre is near
/// where it was in the last message.
class PolygonColors
{
public:
  /// @param centers  [m] of the polygons of a message
  /// @return a hue from 0 to 1 for each
  std::vector<float> assign(const std::vector<Eigen::Vector2d>& centers);

private:
  /// The number of the nearest polygon of the last message, which then is taken.
  unsigned int takeNearest(const Eigen::Vector2d& center);

  std::vector<Eigen::Vector2d> centers_;  ///< of the last message
  std::vector<unsigned int> numbers_;     ///< of their hues
};

}  // namespace polygonal_perception::displays

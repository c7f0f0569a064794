#pragma once

#include <Eigen/Core>
#include <vector>

namespace polygonal_perception {

/// A hue for each polygon. Messages do not number their polygons: one keeps its hue while its centre is near
/// where it was in the last message.
class PolygonColors
{
public:
  /// @param centers  [m] of the polygons of a message
  /// @return a hue from 0 to 1 for each, valid until the next call
  const std::vector<float>& assign(const std::vector<Eigen::Vector2d>& centers);

private:
  std::vector<Eigen::Vector2d> centers_;  ///< of the last message
  std::vector<float> hues_;
  unsigned int count_ = 0;  ///< of hues that were given
};

}  // namespace polygonal_perception

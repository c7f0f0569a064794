#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "polygonal_perception/export.hpp"

namespace polygonal_perception::planning {

/// How far it is to the end of a path for somebody beside it: along a thread that runs from there round the path's corners,
/// pulled taut. Obstacles that the path does not touch do not count, so that it is good near the path.
class POLYGONAL_PERCEPTION_EXPORT RemainingPath
{
public:
  /// What lies ahead of a place.
  struct Way
  {
    double length = 0.0;    ///< [m]
    Eigen::Vector2d ahead;  ///< a point of the thread, some way along it, or its end
  };

  /// @param path  start, corners and goal [m]; at least one point. Memory is used again.
  void setPath(const std::vector<Eigen::Vector2d>& path);
  /// A straight one.
  void setPath(const Eigen::Vector2d& start, const Eigen::Vector2d& goal);

  /// @param ahead  [m] along the thread
  Way from(const Eigen::Vector2d& place, double ahead) const;
  const Eigen::Vector2d& goal() const { return points_.back(); }

private:
  /// Index of the first point that the thread touches.
  std::size_t firstBend(const Eigen::Vector2d& place) const;

  std::vector<Eigen::Vector2d> points_;
  std::vector<double> rest_;  // [m] from each point on
};

}  // namespace polygonal_perception::planning

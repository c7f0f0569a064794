#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "polygonal_perception/geometry/polygon_set.hpp"

namespace polygonal_perception::reference {

/// Shortest paths the plain way: every pair of vertices is tested against every edge, exactly, and Dijkstra's search goes
/// over those that see each other. O(n^3) for n vertices.
class VisibilityGraph
{
public:
  /// @param obstacles  valid (geometry::findDefect), so that none touches another; must outlive the graph
  explicit VisibilityGraph(const geometry::PolygonSet& obstacles);

  /// Whether no point of the segment is inside an obstacle: it may touch them. Its ends are not inside.
  bool sees(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;

  /// @return the length of the shortest path [m]; nothing where there is none
  std::optional<double> shortest(const Eigen::Vector2d& start, const Eigen::Vector2d& goal) const;

private:
  struct Neighbour
  {
    std::size_t vertex;
    double distance;
  };

  const geometry::PolygonSet& obstacles_;
  std::vector<std::vector<Neighbour>> neighbours_;
};

}  // namespace polygonal_perception::reference

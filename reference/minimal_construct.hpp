#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <vector>

#include "polygonal_perception/geometry/polygon_set.hpp"

namespace polygonal_perception::reference {

/// Minimal Construct as its paper has it (M. Missura, D. D. Lee and M. Bennewitz, IROS 2018, algorithms 1 to 3): A* over a
/// visibility graph that begins with start and goal alone. An edge is guessed, and tested against all polygons when it is
/// popped; the polygon that blocks it, the nearest first, then gives its convex corners to the graph.
class MinimalConstruct
{
public:
  /// @param obstacles  valid (geometry::findDefect); must outlive it
  explicit MinimalConstruct(const geometry::PolygonSet& obstacles);

  /// @param start, goal  not inside an obstacle
  /// @return the length of the shortest path [m]; nothing where there is none
  std::optional<double> plan(const Eigen::Vector2d& start, const Eigen::Vector2d& goal);

  /// Of the last plan: lines tested against the scene, and how many of them were blocked.
  std::size_t testedLines() const { return tested_lines_; }
  std::size_t blockedLines() const { return blocked_lines_; }
  std::size_t expandedVertices() const { return expanded_vertices_; }
  const std::vector<Eigen::Vector2d>& path() const { return path_; }

  /// How many edges the whole graph has: those between convex corners that see each other, tangential at both ends.
  std::size_t countEdges() const;

private:
  struct Corner
  {
    Eigen::Vector2d before;
    Eigen::Vector2d at;
    Eigen::Vector2d after;
  };
  struct Polygon
  {
    std::size_t first_ring = 0;
    std::size_t end_ring = 0;
    Eigen::AlignedBox2d box;
    std::vector<Corner> corners;  // convex ones
    bool is_connected = false;
  };
  struct Vertex
  {
    Eigen::Vector2d at = Eigen::Vector2d::Zero();
    const Corner* corner = nullptr;  // null for start and goal
    std::uint32_t parent = 0;
    double length = 0.0;  // [m]
    bool has_parent = false;
    bool is_closed = false;
    std::vector<std::uint32_t> neighbours;
  };
  struct Queued
  {
    double estimate;
    std::uint32_t vertex;
    double length;  // of the vertex when it was pushed: out of date where it differs
    std::uint32_t parent;
    bool operator<(const Queued& other) const { return estimate > other.estimate; }
  };

  /// The polygon that blocks a line nearest to its begin.
  Polygon* blocking(const Eigen::Vector2d& from, const Eigen::Vector2d& to);
  static bool isTangential(const Corner* corner, const Eigen::Vector2d& from);
  void setParent(std::uint32_t parent, std::uint32_t vertex);
  void findParent(std::uint32_t vertex);
  void connect(Polygon& polygon);
  void expand(std::uint32_t vertex);
  double readPath(std::uint32_t goal);

  const geometry::PolygonSet& obstacles_;
  std::vector<Polygon> polygons_;
  std::vector<Vertex> vertices_;
  std::vector<Queued> queue_;
  std::vector<Eigen::Vector2d> path_;
  std::size_t tested_lines_ = 0;
  std::size_t blocked_lines_ = 0;
  std::size_t expanded_vertices_ = 0;
};

}  // namespace polygonal_perception::reference

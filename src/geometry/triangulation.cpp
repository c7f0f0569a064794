#include "polygonal_perception/geometry/triangulation.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace polygonal_perception::geometry {

namespace {

/// An edge of a ring that is not level.
struct Edge
{
  Eigen::Vector2d low;
  Eigen::Vector2d high;

  double xAt(double y) const
  {
    if (y <= low.y()) return low.x();
    if (y >= high.y()) return high.x();
    return low.x() + (y - low.y()) * (high.x() - low.x()) / (high.y() - low.y());
  }
};

std::vector<Edge> edgesOf(const PolygonSet& polygons)
{
  std::vector<Edge> edges;
  for (const PolygonSet::Ring& ring : polygons.rings) {
    for (std::uint32_t i = 0; i < ring.size; ++i) {
      const Eigen::Vector2d& a = polygons.vertices[ring.first + i];
      const Eigen::Vector2d& b = polygons.vertices[ring.first + (i + 1) % ring.size];
      if (a.y() < b.y()) edges.push_back({a, b});
      if (b.y() < a.y()) edges.push_back({b, a});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.low.y() < b.low.y(); });
  return edges;
}

/// The heights at which an edge begins or ends, lowest first.
std::vector<double> levelsOf(const std::vector<Edge>& edges)
{
  std::vector<double> levels;
  for (const Edge& edge : edges) {
    levels.push_back(edge.low.y());
    levels.push_back(edge.high.y());
  }
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

void appendTrapezoid(const Edge& left, const Edge& right, double bottom, double top,
                     std::vector<Eigen::Vector2d>& triangles)
{
  const Eigen::Vector2d a(left.xAt(bottom), bottom);
  const Eigen::Vector2d b(right.xAt(bottom), bottom);
  const Eigen::Vector2d c(right.xAt(top), top);
  const Eigen::Vector2d d(left.xAt(top), top);
  if (a.x() < b.x()) triangles.insert(triangles.end(), {a, b, c});
  if (d.x() < c.x()) triangles.insert(triangles.end(), {a, c, d});
}

}  // namespace

std::vector<Eigen::Vector2d> triangulate(const PolygonSet& polygons)
{
  const std::vector<Edge> edges = edgesOf(polygons);
  const std::vector<double> levels = levelsOf(edges);
  std::vector<Eigen::Vector2d> triangles;

  // A trapezoid stands open from its bottom until one of its two sides ends or another edge comes between
  // them.
  using Sides = std::pair<std::size_t, std::size_t>;
  std::map<Sides, double> open;
  const auto close = [&](const std::map<Sides, double>& trapezoids, double top) {
    for (const auto& [sides, bottom] : trapezoids) {
      appendTrapezoid(edges[sides.first], edges[sides.second], bottom, top, triangles);
    }
  };

  std::vector<std::pair<double, std::size_t>> crossed;  // x and index of the edges between two levels
  std::size_t next_edge = 0;
  for (std::size_t level = 0; level + 1 < levels.size(); ++level) {
    const double bottom = levels[level];
    const double middle = (bottom + levels[level + 1]) / 2.0;
    const auto has_ended = [&](const auto& entry) { return edges[entry.second].high.y() <= bottom; };
    crossed.erase(std::remove_if(crossed.begin(), crossed.end(), has_ended), crossed.end());
    for (; next_edge < edges.size() && edges[next_edge].low.y() <= bottom; ++next_edge) {
      crossed.emplace_back(0.0, next_edge);
    }
    for (auto& [x, edge] : crossed) x = edges[edge].xAt(middle);
    std::sort(crossed.begin(), crossed.end());

    // From left to right every other gap is inside.
    std::map<Sides, double> still_open;
    for (std::size_t i = 0; i + 1 < crossed.size(); i += 2) {
      const Sides sides(crossed[i].second, crossed[i + 1].second);
      const auto known = open.find(sides);
      still_open[sides] = known == open.end() ? bottom : known->second;
      if (known != open.end()) open.erase(known);
    }
    close(open, bottom);
    open.swap(still_open);
  }
  if (!levels.empty()) close(open, levels.back());
  return triangles;
}

}  // namespace polygonal_perception::geometry

#include "polygonal_perception/geometry/triangulation.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace polygonal_perception::geometry {

namespace {

/// An edge of a ring that is not level.
struct Side
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

std::vector<Side> sidesOf(const PolygonSet& polygons)
{
  std::vector<Side> sides;
  for (const PolygonSet::Ring& ring : polygons.rings) {
    for (const auto [from, to] : polygons.view(ring).edges()) {
      if (from.y() < to.y()) sides.push_back({from, to});
      if (to.y() < from.y()) sides.push_back({to, from});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.low.y() < b.low.y(); });
  return sides;
}

/// The heights at which an edge begins or ends, lowest first.
std::vector<double> levelsOf(const std::vector<Side>& sides)
{
  std::vector<double> levels;
  for (const Side& side : sides) {
    levels.push_back(side.low.y());
    levels.push_back(side.high.y());
  }
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

void appendTrapezoid(const Side& left, const Side& right, double bottom, double top,
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
  const std::vector<Side> sides = sidesOf(polygons);
  const std::vector<double> levels = levelsOf(sides);
  std::vector<Eigen::Vector2d> triangles;

  // A trapezoid stands open from its bottom until one of its two sides ends or another one comes between
  // them.
  using Pair = std::pair<std::size_t, std::size_t>;
  std::map<Pair, double> open;
  const auto close = [&](const std::map<Pair, double>& trapezoids, double top) {
    for (const auto& [pair, bottom] : trapezoids) {
      appendTrapezoid(sides[pair.first], sides[pair.second], bottom, top, triangles);
    }
  };

  std::vector<std::pair<double, std::size_t>> crossed;  // x and index of the sides between two levels
  std::size_t next_side = 0;
  for (std::size_t level = 0; level + 1 < levels.size(); ++level) {
    const double bottom = levels[level];
    const double middle = (bottom + levels[level + 1]) / 2.0;
    const auto has_ended = [&](const auto& entry) { return sides[entry.second].high.y() <= bottom; };
    crossed.erase(std::remove_if(crossed.begin(), crossed.end(), has_ended), crossed.end());
    for (; next_side < sides.size() && sides[next_side].low.y() <= bottom; ++next_side) {
      crossed.emplace_back(0.0, next_side);
    }
    for (auto& [x, side] : crossed) x = sides[side].xAt(middle);
    std::sort(crossed.begin(), crossed.end());

    // From left to right every other gap is inside.
    std::map<Pair, double> still_open;
    for (std::size_t i = 0; i + 1 < crossed.size(); i += 2) {
      const Pair pair(crossed[i].second, crossed[i + 1].second);
      const auto known = open.find(pair);
      still_open[pair] = known == open.end() ? bottom : known->second;
      if (known != open.end()) open.erase(known);
    }
    close(open, bottom);
    open.swap(still_open);
  }
  if (!levels.empty()) close(open, levels.back());
  return triangles;
}

}  // namespace polygonal_perception::geometry

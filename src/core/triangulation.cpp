#include "polygonal_perception/triangulation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace polygonal_perception {

namespace {

using Index = std::uint32_t;

/// Twice the area of the triangle a, b, c; positive when it runs counter-clockwise.
double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// A boundary that takes in its holes and is then eaten up, ear by ear.
class EarClipper
{
public:
  explicit EarClipper(const std::vector<Eigen::Vector2d>& vertices) : vertices_(vertices) {}

  void setBoundary(const PolygonSet::Ring& boundary)
  {
    ring_.clear();
    holes_.clear();
    append(boundary, ring_);
  }

  void addHole(const PolygonSet::Ring& hole) { append(hole, holes_.emplace_back()); }

  void clip(std::vector<Index>& triangles)
  {
    // A hole that reaches farther right is never behind another one, seen along +x.
    for (auto& hole : holes_) {
      std::rotate(hole.begin(),
                  std::max_element(hole.begin(), hole.end(),
                                   [this](Index a, Index b) { return at(a).x() < at(b).x(); }),
                  hole.end());
    }
    std::sort(holes_.begin(), holes_.end(),
              [this](const auto& a, const auto& b) { return at(a.front()).x() > at(b.front()).x(); });
    for (const auto& hole : holes_) bridge(hole);
    clipEars(triangles);
  }

private:
  const Eigen::Vector2d& at(Index i) const { return vertices_[i]; }

  static void append(const PolygonSet::Ring& from, std::vector<Index>& to)
  {
    for (Index i = 0; i < from.size; ++i) to.push_back(from.first + i);
  }

  /// Whether p lies in the triangle a, b, c (counter-clockwise) or on its edge, its corners excepted.
  bool inTriangle(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                  const Eigen::Vector2d& c) const
  {
    if (p == a || p == b || p == c) return false;
    return turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
  }

  /// Joins a hole, which begins with its rightmost vertex, to the ring by two edges to a vertex that it can
  /// see.
  void bridge(const std::vector<Index>& hole)
  {
    const std::size_t anchor = visibleFrom(hole);
    std::vector<Index> detour(hole);
    detour.push_back(hole.front());
    detour.push_back(ring_[anchor]);
    ring_.insert(ring_.begin() + static_cast<std::ptrdiff_t>(anchor) + 1, detour.begin(), detour.end());
  }

  /// The position in the ring of a vertex that can be seen from the first vertex of a hole (Eberly's method).
  std::size_t visibleFrom(const std::vector<Index>& hole) const
  {
    const Eigen::Vector2d& eye = at(hole.front());
    // A hole that touches the ring there is joined there, in the corner that the hole lies in.
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      if (at(ring_[i]) == eye) return mostOpen(i, at(hole.back()));
    }
    // The edge that a ray along +x hits first, and of its ends the one farther right.
    std::size_t candidate = 0;
    double hit_x = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const std::size_t next = (i + 1) % ring_.size();
      const Eigen::Vector2d& a = at(ring_[i]);
      const Eigen::Vector2d& b = at(ring_[next]);
      // Inside the ring, edges to the right of a point run upwards.
      if (!(a.y() <= eye.y() && b.y() >= eye.y()) || a.y() == b.y()) continue;
      const double x = a.x() + (eye.y() - a.y()) * (b.x() - a.x()) / (b.y() - a.y());
      if (x < eye.x() || x >= hit_x) continue;
      hit_x = x;
      candidate = a.x() > b.x() ? i : next;
    }
    // Reflex vertices in the triangle of eye, hit and candidate hide it: of those, the one nearest to the ray
    // is seen.
    const Eigen::Vector2d hit(hit_x, eye.y());
    const Eigen::Vector2d corner = at(ring_[candidate]);
    const bool above = corner.y() > eye.y();
    const Eigen::Vector2d& second = above ? hit : corner;
    const Eigen::Vector2d& third = above ? corner : hit;
    double best_slope = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const Eigen::Vector2d& p = at(ring_[i]);
      if (p.x() <= eye.x() || !inTriangle(p, eye, second, third)) continue;
      const double slope = std::abs(p.y() - eye.y()) / (p.x() - eye.x());
      if (slope < best_slope) {
        best_slope = slope;
        candidate = i;
      }
    }
    return mostOpen(candidate, eye);
  }

  /// Of the places in the ring where its vertex stands (several after a bridge), the one into whose corner
  /// `eye` sees.
  std::size_t mostOpen(std::size_t candidate, const Eigen::Vector2d& eye) const
  {
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      if (at(ring_[i]) != at(ring_[candidate])) continue;
      const Eigen::Vector2d& before = at(ring_[(i + ring_.size() - 1) % ring_.size()]);
      const Eigen::Vector2d& here = at(ring_[i]);
      const Eigen::Vector2d& after = at(ring_[(i + 1) % ring_.size()]);
      const bool left_of_in = turn(before, here, eye) >= 0.0;
      const bool left_of_out = turn(here, after, eye) >= 0.0;
      const bool convex = turn(before, here, after) >= 0.0;
      if (convex ? (left_of_in && left_of_out) : (left_of_in || left_of_out)) return i;
    }
    return candidate;
  }

  bool isEar(std::size_t i) const
  {
    const Index before = previous_[i];
    const Index after = next_[i];
    const Eigen::Vector2d& a = at(ring_[before]);
    const Eigen::Vector2d& b = at(ring_[i]);
    const Eigen::Vector2d& c = at(ring_[after]);
    if (turn(a, b, c) <= 0.0) return false;
    for (Index k = next_[after]; k != before; k = next_[k]) {
      if (inTriangle(at(ring_[k]), a, b, c)) return false;
    }
    return true;
  }

  void clipEars(std::vector<Index>& triangles)
  {
    const std::size_t size = ring_.size();
    previous_.resize(size);
    next_.resize(size);
    for (std::size_t i = 0; i < size; ++i) {
      previous_[i] = static_cast<Index>((i + size - 1) % size);
      next_[i] = static_cast<Index>((i + 1) % size);
    }
    Index here = 0;
    std::size_t left = size;
    std::size_t since_last_ear = 0;
    while (left >= 3) {
      // Without an ear the ring is degenerate: cut anywhere, so that it ends.
      const bool stuck = since_last_ear > left;
      if (!stuck && !isEar(here)) {
        here = next_[here];
        ++since_last_ear;
        continue;
      }
      const std::array<Index, 3> corners = {ring_[previous_[here]], ring_[here], ring_[next_[here]]};
      if (turn(at(corners[0]), at(corners[1]), at(corners[2])) > 0.0) {
        triangles.insert(triangles.end(), corners.begin(), corners.end());
      }
      next_[previous_[here]] = next_[here];
      previous_[next_[here]] = previous_[here];
      // Skipping one gives fans of fewer slivers than cutting the neighbour next.
      here = next_[next_[here]];
      --left;
      since_last_ear = 0;
    }
  }

  const std::vector<Eigen::Vector2d>& vertices_;
  std::vector<Index> ring_;
  std::vector<std::vector<Index>> holes_;
  std::vector<Index> previous_;
  std::vector<Index> next_;
};

}  // namespace

std::vector<std::uint32_t> triangulate(const PolygonSet& polygons)
{
  std::vector<std::uint32_t> triangles;
  EarClipper clipper(polygons.vertices);
  for (std::size_t r = 0; r < polygons.rings.size(); ++r) {
    const PolygonSet::Ring& ring = polygons.rings[r];
    if (ring.hole) {
      clipper.addHole(ring);
    } else {
      clipper.setBoundary(ring);
    }
    const bool last_of_polygon = r + 1 == polygons.rings.size() || !polygons.rings[r + 1].hole;
    if (last_of_polygon) clipper.clip(triangles);
  }
  return triangles;
}

}  // namespace polygonal_perception

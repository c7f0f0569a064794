#include "reference/visibility_graph.hpp"

#include <limits>

#include "polygonal_perception/geometry/predicates.hpp"

namespace polygonal_perception::reference {

using geometry::orientation;
using geometry::Orientation;

namespace {

bool isLeft(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return orientation(a, b, p) == Orientation::kCounterClockwise;
}

/// Whether who leaves vertex k of a ring towards `to` enters the obstacle, which lies to the left of the ring's edges.
bool entersAtVertex(const geometry::RingView& ring, std::size_t k, const Eigen::Vector2d& to)
{
  const Eigen::Vector2d& before = ring[ring.previous(k)];
  const Eigen::Vector2d& at = ring[k];
  const Eigen::Vector2d& after = ring[ring.next(k)];
  const bool left_of_first = isLeft(to, before, at);
  const bool left_of_second = isLeft(to, at, after);
  switch (orientation(before, at, after)) {
    case Orientation::kCounterClockwise:
      return left_of_first && left_of_second;
    case Orientation::kCollinear:
      return left_of_second;
    case Orientation::kClockwise:
      break;
  }
  // A corner of more than half a turn: all directions enter it but those right of or along both edges.
  const auto runsAlong = [&](const Eigen::Vector2d& end) {
    return orientation(at, end, to) == Orientation::kCollinear && (end - at).dot(to - at) > 0.0;
  };
  return (left_of_first || left_of_second) && !runsAlong(before) && !runsAlong(after);
}

}  // namespace

VisibilityGraph::VisibilityGraph(const geometry::PolygonSet& obstacles)
    : obstacles_(obstacles), neighbours_(obstacles.vertices.size())
{
  for (std::size_t i = 0; i < neighbours_.size(); ++i) {
    for (std::size_t j = i + 1; j < neighbours_.size(); ++j) {
      if (!sees(obstacles.vertices[i], obstacles.vertices[j])) continue;
      const double distance = (obstacles.vertices[i] - obstacles.vertices[j]).norm();
      neighbours_[i].push_back({j, distance});
      neighbours_[j].push_back({i, distance});
    }
  }
}

bool VisibilityGraph::sees(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const
{
  if (from == to) return true;
  for (const geometry::PolygonSet::Ring& part : obstacles_.rings) {
    const geometry::RingView ring = obstacles_.view(part);
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const auto [a, b] = ring.edge(k);
      switch (geometry::segmentContact(from, to, a, b)) {
        case geometry::SegmentContact::kNone:
          continue;
        case geometry::SegmentContact::kCross:
          return false;
        case geometry::SegmentContact::kTouch:
        case geometry::SegmentContact::kOverlap:
          break;
      }
      if (geometry::isOnSegment(a, from, to)) {
        if (a != to && entersAtVertex(ring, k, to)) return false;
        if (a != from && entersAtVertex(ring, k, from)) return false;
      }
      // An end of the segment between the ends of the edge.
      if (from != a && from != b && geometry::isOnSegment(from, a, b) && isLeft(to, a, b)) return false;
      if (to != a && to != b && geometry::isOnSegment(to, a, b) && isLeft(from, a, b)) return false;
    }
  }
  return true;
}

std::optional<double> VisibilityGraph::shortest(const Eigen::Vector2d& start,
                                                const Eigen::Vector2d& goal) const
{
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double best = sees(start, goal) ? (goal - start).norm() : kInfinity;
  const std::size_t count = neighbours_.size();
  std::vector<double> length(count, kInfinity);
  std::vector<bool> is_done(count, false);
  for (std::size_t i = 0; i < count; ++i)
    if (sees(start, obstacles_.vertices[i])) length[i] = (obstacles_.vertices[i] - start).norm();
  for (;;) {
    std::size_t next = count;
    for (std::size_t i = 0; i < count; ++i)
      if (!is_done[i] && length[i] < (next == count ? best : length[next])) next = i;
    if (next == count) break;
    is_done[next] = true;
    if (sees(obstacles_.vertices[next], goal))
      best = std::min(best, length[next] + (goal - obstacles_.vertices[next]).norm());
    for (const Neighbour& neighbour : neighbours_[next])
      length[neighbour.vertex] = std::min(length[neighbour.vertex], length[next] + neighbour.distance);
  }
  if (best == kInfinity) return std::nullopt;
  return best;
}

}  // namespace polygonal_perception::reference

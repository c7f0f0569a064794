#include "reference/line_of_sight.hpp"

#include <algorithm>
#include <cmath>

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

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/// Whether both points lie on one side of a line, beyond doubt: rounding is less than 1e-9 m2 within 1 km.
bool areSurelyBeside(const Eigen::Vector2d& from, const Eigen::Vector2d& along, const Eigen::Vector2d& a,
                     const Eigen::Vector2d& b)
{
  constexpr double kRounding = 1e-9;  // [m2]
  const double of_a = cross(along, a - from);
  const double of_b = cross(along, b - from);
  return (of_a > kRounding && of_b > kRounding) || (of_a < -kRounding && of_b < -kRounding);
}

}  // namespace

std::optional<double> blockedAt(const geometry::RingView& ring, const Eigen::Vector2d& from,
                                const Eigen::Vector2d& to)
{
  const Eigen::Vector2d along = to - from;
  std::optional<double> first;
  const auto block = [&](const Eigen::Vector2d& place) {
    const double share = (place - from).dot(along) / along.squaredNorm();
    if (!first || share < *first) first = share;
  };
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const auto [a, b] = ring.edge(k);
    if (areSurelyBeside(from, along, a, b)) continue;
    switch (geometry::segmentContact(from, to, a, b)) {
      case geometry::SegmentContact::kNone:
        continue;
      case geometry::SegmentContact::kCross:
        block(a + std::clamp(cross(along, a - from) / cross(along, a - b), 0.0, 1.0) * (b - a));
        continue;
      case geometry::SegmentContact::kTouch:
      case geometry::SegmentContact::kOverlap:
        break;
    }
    if (geometry::isOnSegment(a, from, to)) {
      if (a != to && entersAtVertex(ring, k, to)) block(a);
      if (a != from && entersAtVertex(ring, k, from)) block(a);
    }
    // An end of the segment between the ends of the edge.
    if (from != a && from != b && geometry::isOnSegment(from, a, b) && isLeft(to, a, b)) block(from);
    if (to != a && to != b && geometry::isOnSegment(to, a, b) && isLeft(from, a, b)) block(to);
  }
  return first;
}

}  // namespace polygonal_perception::reference

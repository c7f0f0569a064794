#include <algorithm>

#include "polygonal_perception/geometry/predicates.hpp"

namespace polygonal_perception::geometry {

namespace {

using Point = Eigen::Vector2d;

/// Whether p is in the bounding box of a and b.
bool isInBox(const Point& p, const Point& a, const Point& b)
{
  return p.x() >= std::min(a.x(), b.x()) && p.x() <= std::max(a.x(), b.x()) &&
         p.y() >= std::min(a.y(), b.y()) && p.y() <= std::max(a.y(), b.y());
}

bool boxesAreApart(const Point& a, const Point& b, const Point& c, const Point& d)
{
  return std::max(a.x(), b.x()) < std::min(c.x(), d.x()) || std::max(c.x(), d.x()) < std::min(a.x(), b.x()) ||
         std::max(a.y(), b.y()) < std::min(c.y(), d.y()) || std::max(c.y(), d.y()) < std::min(a.y(), b.y());
}

/// Of segments on one line whose boxes are not apart.
SegmentContact collinearContact(const Point& a, const Point& b, const Point& c, const Point& d)
{
  // Ordered along the line, the common part is from the later begin to the earlier end.
  const auto before = [](const Point& p, const Point& q) {
    return p.x() < q.x() || (p.x() == q.x() && p.y() < q.y());
  };
  const Point& begin = std::max(std::min(a, b, before), std::min(c, d, before), before);
  const Point& end = std::min(std::max(a, b, before), std::max(c, d, before), before);
  if (before(end, begin)) return SegmentContact::kNone;
  return before(begin, end) ? SegmentContact::kOverlap : SegmentContact::kTouch;
}

}  // namespace

bool isOnSegment(const Point& p, const Point& a, const Point& b)
{
  return isInBox(p, a, b) && orientation(a, b, p) == Orientation::kCollinear;
}

SegmentContact segmentContact(const Point& a, const Point& b, const Point& c, const Point& d)
{
  if (boxesAreApart(a, b, c, d)) return SegmentContact::kNone;
  const Orientation abc = orientation(a, b, c);
  const Orientation abd = orientation(a, b, d);
  if (abc == abd && abc != Orientation::kCollinear) return SegmentContact::kNone;
  const Orientation cda = orientation(c, d, a);
  const Orientation cdb = orientation(c, d, b);
  if (cda == cdb && cda != Orientation::kCollinear) return SegmentContact::kNone;

  const auto all = [&](auto holds) { return holds(abc) && holds(abd) && holds(cda) && holds(cdb); };
  if (all([](Orientation turn) { return turn == Orientation::kCollinear; })) {
    return collinearContact(a, b, c, d);
  }
  // Neither has the other one on one side, so that they meet; an end lies on the other one or none does.
  return all([](Orientation turn) { return turn != Orientation::kCollinear; }) ? SegmentContact::kCross
                                                                               : SegmentContact::kTouch;
}

bool segmentsIntersect(const Point& a, const Point& b, const Point& c, const Point& d)
{
  return segmentContact(a, b, c, d) != SegmentContact::kNone;
}

bool segmentsCross(const Point& a, const Point& b, const Point& c, const Point& d)
{
  return segmentContact(a, b, c, d) == SegmentContact::kCross;
}

}  // namespace polygonal_perception::geometry

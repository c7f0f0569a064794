#include "geometry/segment_insertion.hpp"

#include "polygonal_perception/geometry/constrained_triangulation.hpp"
#include "polygonal_perception/geometry/predicates.hpp"

namespace polygonal_perception::geometry {

std::optional<Eigen::Vector2d> SegmentInsertion::insert(std::uint32_t from, std::uint32_t to,
                                                        std::int32_t step)
{
  goals_.assign(1, to);
  while (!goals_.empty()) {
    const std::uint32_t goal = goals_.back();
    if (from == goal) {
      goals_.pop_back();
      continue;
    }
    const Reach reached = reach(from, goal);
    if (reached.crossed != TriangleMesh::kNone) {
      const Eigen::Vector2d place = mesh_.originPoint(reached.crossed);
      if (crossings_left_ == 0) return place;
      --crossings_left_;
      const std::uint32_t vertex = cross(reached.crossed, mesh_.vertices[from], mesh_.vertices[goal]);
      if (vertex == TriangleMesh::kNone) return place;
      goals_.push_back(vertex);
      continue;
    }
    clearWay(from, reached.vertex);
    constrain(from, reached.vertex, step);
    from = reached.vertex;
  }
  return std::nullopt;
}

SegmentInsertion::Reach SegmentInsertion::reach(std::uint32_t from, std::uint32_t to)
{
  crossing_.clear();
  const Eigen::Vector2d& a = mesh_.vertices[from];
  const Eigen::Vector2d& b = mesh_.vertices[to];
  // Around `from`, the edge through which the segment leaves, or the first one that it runs along.
  std::uint32_t spoke = mesh_.outgoing[from];
  std::uint32_t edge = TriangleMesh::kNone;
  for (;;) {
    const Eigen::Vector2d& p = mesh_.targetPoint(spoke);
    const Orientation right = orientation(a, b, p);
    if (right == Orientation::kCollinear && (p - a).dot(b - a) > 0.0) return {mesh_.target(spoke)};
    if (right == Orientation::kClockwise &&
        orientation(a, b, mesh_.apexPoint(spoke)) == Orientation::kCounterClockwise) {
      edge = TriangleMesh::next(spoke);
      break;
    }
    spoke = mesh_.nextAround(spoke);
  }
  for (;;) {
    if (mesh_.half_edges[edge].constrained) return {TriangleMesh::kNone, edge};
    crossing_.emplace_back(mesh_.origin(edge), mesh_.target(edge));
    const std::uint32_t beyond = mesh_.twin(edge);
    switch (orientation(a, b, mesh_.apexPoint(beyond))) {
      case Orientation::kCollinear:
        return {mesh_.apex(beyond)};
      case Orientation::kClockwise:
        edge = TriangleMesh::previous(beyond);
        break;
      case Orientation::kCounterClockwise:
        edge = TriangleMesh::next(beyond);
        break;
    }
  }
}

std::uint32_t SegmentInsertion::cross(std::uint32_t half_edge, const Eigen::Vector2d& from,
                                      const Eigen::Vector2d& to)
{
  const Eigen::Vector2d& c = mesh_.originPoint(half_edge);
  const Eigen::Vector2d& d = mesh_.targetPoint(half_edge);
  const Eigen::Vector2d along = to - from;
  const Eigen::Vector2d across = d - c;
  const double slope = along.x() * across.y() - along.y() * across.x();
  const Eigen::Vector2d apart = from - c;
  const double share = (along.x() * apart.y() - along.y() * apart.x()) / slope;
  const Eigen::Vector2d place = c + share * across;
  const auto isLeft = [&](const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
    return orientation(p, q, place) == Orientation::kCounterClockwise;
  };
  // Rounding moves the place off the edge, but not out of the quadrilateral around it.
  const Eigen::Vector2d& left = mesh_.apexPoint(half_edge);
  const Eigen::Vector2d& right = mesh_.apexPoint(mesh_.twin(half_edge));
  if (!(isLeft(d, left) && isLeft(left, c) && isLeft(c, right) && isLeft(right, d)))
    return TriangleMesh::kNone;
  return editor_.splitEdge(half_edge, place);
}

void SegmentInsertion::clearWay(std::uint32_t from, std::uint32_t to)
{
  const Eigen::Vector2d a = mesh_.vertices[from];
  const Eigen::Vector2d b = mesh_.vertices[to];
  // A queue in a vector: what cannot be flipped yet comes again.
  for (std::size_t i = 0; i < crossing_.size(); ++i) {
    const auto ends = crossing_[i];
    const std::uint32_t edge = find(ends.first, ends.second);
    const std::uint32_t c = mesh_.apex(edge);
    const std::uint32_t d = mesh_.apex(mesh_.twin(edge));
    const Eigen::Vector2d& c_point = mesh_.vertices[c];
    const Eigen::Vector2d& d_point = mesh_.vertices[d];
    const Orientation first = orientation(c_point, d_point, mesh_.originPoint(edge));
    const Orientation second = orientation(c_point, d_point, mesh_.targetPoint(edge));
    if (first == Orientation::kCollinear || second == Orientation::kCollinear || first == second) {
      crossing_.push_back(ends);
      continue;
    }
    editor_.flip(edge);
    if (c != from && c != to && d != from && d != to && segmentsCross(a, b, c_point, d_point))
      crossing_.emplace_back(d, c);
  }
}

void SegmentInsertion::constrain(std::uint32_t from, std::uint32_t to, std::int32_t step)
{
  const std::uint32_t edge = find(from, to);
  const std::uint32_t twin = mesh_.twin(edge);
  mesh_.half_edges[edge].constrained = mesh_.half_edges[twin].constrained = true;
  mesh_.half_edges[edge].step += step;
  mesh_.half_edges[twin].step -= step;
}

std::uint32_t SegmentInsertion::find(std::uint32_t from, std::uint32_t to) const
{
  // Around a corner of the region one cannot go all the way; of an edge that is in the way one end is none.
  if (from < ConstrainedTriangulation::kSquareCorners) return mesh_.twin(find(to, from));
  std::uint32_t spoke = mesh_.outgoing[from];
  while (mesh_.target(spoke) != to) spoke = mesh_.nextAround(spoke);
  return spoke;
}

}  // namespace polygonal_perception::geometry

#include "polygonal_perception/planning/path_search.hpp"

#include <algorithm>
#include <limits>

#include "planning/interval_length.hpp"
#include "polygonal_perception/geometry/predicates.hpp"

namespace polygonal_perception::planning {

using geometry::orientation;
using geometry::Orientation;
using geometry::TriangleMesh;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

void PathSearch::setSpace(const FreeSpace& space)
{
  space_ = &space;
  const auto& vertices = space.mesh().vertices;
  points_.assign(vertices.begin(), vertices.end());
  start_ = static_cast<std::uint32_t>(points_.size());
  goal_ = start_ + 1;
  points_.resize(points_.size() + 2);
  best_.assign(points_.size(), kInfinity);
  touched_.clear();
  has_goal_.assign(space.mesh().triangleCount(), 0);
  goal_triangles_.clear();
}

std::optional<double> PathSearch::plan(const FreePlace& start, const FreePlace& goal,
                                       std::vector<Eigen::Vector2d>& path)
{
  path.clear();
  for (const std::uint32_t index : touched_) best_[index] = kInfinity;
  touched_.clear();
  visits_.clear();
  cones_.clear();
  crossings_.clear();
  queue_.clear();
  reached_ = kNone;
  expanded_corners_ = crossed_triangles_ = 0;
  points_[start_] = start.point;
  points_[goal_] = goal.point;
  markGoal(goal);

  expandStart(start);
  while (!queue_.empty()) {
    const Queued next = queue_.front();
    std::pop_heap(queue_.begin(), queue_.end());
    queue_.pop_back();
    if (next.is_cone) {
      const Cone& cone = cones_[next.index];
      const Visit& root = visits_[cone.root];
      if (root.length <= best_[root.point]) follow(cone);
      continue;
    }
    const Visit& visit = visits_[next.index];
    if (visit.length > best_[visit.point]) continue;
    if (visit.point == goal_) {
      reached_ = next.index;
      return read(next.index, path);
    }
    expandCorner(next.index);
  }
  return std::nullopt;
}

void PathSearch::markGoal(const FreePlace& goal)
{
  for (const std::uint32_t triangle : goal_triangles_) has_goal_[triangle] = 0;
  goal_triangles_.clear();
  space_->forEachTriangleAt(goal, [this](std::uint32_t half_edge) {
    goal_triangles_.push_back(TriangleMesh::triangleOf(half_edge));
    has_goal_[goal_triangles_.back()] = 1;
  });
}

void PathSearch::expandStart(const FreePlace& start)
{
  best_[start_] = 0.0;
  touched_.push_back(start_);
  visits_.push_back({start_, kNone, kNone, kNone, 0.0});
  space_->forEachTriangleAt(start, [&](std::uint32_t first) {
    const TriangleMesh& mesh = space_->mesh();
    const std::uint32_t beginning = cross(first, kNone);
    if (has_goal_[TriangleMesh::triangleOf(first)] != 0) reach(0, goal_, kNone, beginning);
    std::uint32_t edge = first;
    for (int i = 0; i < 3; ++i, edge = TriangleMesh::next(edge)) {
      see(0, edge, beginning);
      // Not through an edge on which the start lies, nor through one that ends in it.
      if (i == 0 && start.on_edge) continue;
      if (i == 2 && start.at_origin) continue;
      push({0, edge, beginning, {start_, mesh.origin(edge)}, {start_, mesh.target(edge)}});
    }
  });
}

void PathSearch::expandCorner(std::uint32_t visit)
{
  ++expanded_corners_;
  turn(visit, Orientation::kClockwise);
  turn(visit, Orientation::kCounterClockwise);
}

void PathSearch::turn(std::uint32_t visit, Orientation way)
{
  const TriangleMesh& mesh = space_->mesh();
  const bool is_right = way == Orientation::kClockwise;
  const std::uint32_t corner = visits_[visit].point;
  const Side ahead{visits_[visits_[visit].parent].point, corner};
  // Through the triangles around the corner, to those that are reached by half a turn or more from where the path comes
  // from.
  std::uint32_t crossing = visits_[visit].crossing;
  for (std::uint32_t spoke = visits_[visit].half_edge;;) {
    if (has_goal_[TriangleMesh::triangleOf(spoke)] != 0) reach(visit, goal_, kNone, crossing);
    const std::uint32_t edge = TriangleMesh::next(spoke);
    const std::uint32_t far_end = is_right ? mesh.origin(edge) : mesh.target(edge);
    const std::uint32_t near_end = is_right ? mesh.target(edge) : mesh.origin(edge);
    if (isReached(ahead, far_end, way)) {
      see(visit, is_right ? edge : TriangleMesh::next(edge), crossing);
      const Orientation near_side = sideOf(ahead, near_end);
      const bool whole = near_side == way || near_side == Orientation::kCollinear;
      const Side outer{corner, far_end};
      const Side inner = whole ? Side{corner, near_end} : ahead;
      if (sideOf(ahead, far_end) == way)
        push({visit, edge, crossing, is_right ? outer : inner, is_right ? inner : outer, is_right || whole,
              !is_right || whole});
    }
    const std::uint32_t side = is_right ? spoke : TriangleMesh::previous(spoke);
    if (!space_->isOpen(side)) return;
    crossing = cross(side, crossing);
    spoke = is_right ? mesh.previousAround(spoke) : mesh.nextAround(spoke);
  }
}

bool PathSearch::isReached(const Side& ahead, std::uint32_t index, Orientation way) const
{
  const Orientation side = sideOf(ahead, index);
  if (side != Orientation::kCollinear) return side == way;
  return (point(index) - point(ahead.to)).dot(point(ahead.to) - point(ahead.from)) > 0.0;
}

Orientation PathSearch::sideOf(const Side& side, std::uint32_t index) const
{
  return orientation(point(side.from), point(side.to), point(index));
}

void PathSearch::follow(Cone cone)
{
  const TriangleMesh& mesh = space_->mesh();
  for (;;) {
    ++crossed_triangles_;
    cone.crossing = cross(cone.half_edge, cone.crossing);
    const std::uint32_t beyond = mesh.twin(cone.half_edge);
    if (has_goal_[TriangleMesh::triangleOf(beyond)] != 0) seeGoal(cone);
    const std::uint32_t apex = mesh.apex(beyond);
    const Orientation of_right = sideOf(cone.right, apex);
    const Orientation of_left = sideOf(cone.left, apex);
    Cone right = cone;
    right.half_edge = TriangleMesh::next(beyond);
    Cone left = cone;
    left.half_edge = TriangleMesh::previous(beyond);
    bool goes_right = space_->isOpen(right.half_edge);
    bool goes_left = space_->isOpen(left.half_edge);
    if (of_right == Orientation::kClockwise) {
      goes_right = false;
      left.has_right_end = false;
    } else if (of_left == Orientation::kCounterClockwise) {
      goes_left = false;
      right.has_left_end = false;
    } else {
      const std::uint32_t root = visits_[cone.root].point;
      see(cone.root, TriangleMesh::previous(beyond), cone.crossing);
      right.left = left.right = {root, apex};
      right.has_left_end = left.has_right_end = true;
      // A cone without a width shows nothing that its corners do not see.
      goes_right = goes_right && of_right == Orientation::kCounterClockwise;
      goes_left = goes_left && of_left == Orientation::kClockwise;
    }
    if (goes_right == goes_left) {
      if (!goes_right) return;
      push(right);
      push(left);
      return;
    }
    cone = goes_right ? right : left;
  }
}

void PathSearch::seeGoal(const Cone& cone)
{
  if (sideOf(cone.right, goal_) == Orientation::kClockwise) return;
  if (sideOf(cone.left, goal_) == Orientation::kCounterClockwise) return;
  reach(cone.root, goal_, kNone, cone.crossing);
}

void PathSearch::see(std::uint32_t root, std::uint32_t half_edge, std::uint32_t crossing)
{
  const std::uint32_t vertex = space_->mesh().origin(half_edge);
  const std::uint32_t from = visits_[root].point;
  if (has_goal_[TriangleMesh::triangleOf(half_edge)] != 0 && point(vertex) == point(goal_))
    reach(root, goal_, kNone, crossing);
  if (space_->corner(half_edge) == nullptr || point(vertex) == point(from)) return;
  if (isTangential(from, half_edge)) reach(root, vertex, half_edge, crossing);
}

bool PathSearch::isTangential(std::uint32_t from, std::uint32_t half_edge) const
{
  const FreeSpace::Corner& corner = *space_->corner(half_edge);
  const Side ahead{from, space_->mesh().origin(half_edge)};
  return isReached(ahead, corner.first, Orientation::kClockwise) ||
         isReached(ahead, corner.last, Orientation::kCounterClockwise);
}

void PathSearch::reach(std::uint32_t root, std::uint32_t index, std::uint32_t half_edge,
                       std::uint32_t crossing)
{
  const double length = visits_[root].length + (point(index) - point(visits_[root].point)).norm();
  if (length >= best_[index]) return;
  if (best_[index] == kInfinity) touched_.push_back(index);
  best_[index] = length;
  visits_.push_back({index, root, half_edge, crossing, length});
  queue_.push_back(
      {length + (point(goal_) - point(index)).norm(), static_cast<std::uint32_t>(visits_.size() - 1), false});
  std::push_heap(queue_.begin(), queue_.end());
}

std::uint32_t PathSearch::cross(std::uint32_t half_edge, std::uint32_t before)
{
  crossings_.push_back({half_edge, before});
  return static_cast<std::uint32_t>(crossings_.size() - 1);
}

void PathSearch::push(const Cone& cone)
{
  if (!space_->isOpen(cone.half_edge)) return;
  cones_.push_back(cone);
  queue_.push_back({estimate(cone), static_cast<std::uint32_t>(cones_.size() - 1), true});
  std::push_heap(queue_.begin(), queue_.end());
}

Eigen::Vector2d PathSearch::crossing(const Side& side, std::uint32_t half_edge) const
{
  return lineCrossing(point(side.from), point(side.to), space_->mesh().originPoint(half_edge),
                      space_->mesh().targetPoint(half_edge));
}

double PathSearch::estimate(const Cone& cone) const
{
  const TriangleMesh& mesh = space_->mesh();
  const Visit& root = visits_[cone.root];
  return root.length +
         lengthThrough(
             cone.has_right_end ? mesh.originPoint(cone.half_edge) : crossing(cone.right, cone.half_edge),
             cone.has_left_end ? mesh.targetPoint(cone.half_edge) : crossing(cone.left, cone.half_edge),
             point(root.point), point(goal_));
}

double PathSearch::read(std::uint32_t visit, std::vector<Eigen::Vector2d>& path) const
{
  const double length = visits_[visit].length;
  for (std::uint32_t at = visit; at != kNone; at = visits_[at].parent)
    path.push_back(point(visits_[at].point));
  std::reverse(path.begin(), path.end());
  return length;
}

void PathSearch::sleeve(Sleeve& sleeve) const
{
  sleeve.crossed.clear();
  if (reached_ == kNone) return;
  std::uint32_t at = visits_[reached_].crossing;
  for (; crossings_[at].before != kNone; at = crossings_[at].before)
    sleeve.cross(crossings_[at].half_edge, space_->mesh());
  sleeve.first = crossings_[at].half_edge;
  std::reverse(sleeve.crossed.begin(), sleeve.crossed.end());
}

void PathSearch::seenEdges(std::vector<SeenEdge>& edges) const
{
  edges.clear();
  for (const Visit& visit : visits_)
    if (visit.parent != kNone) edges.push_back({point(visits_[visit.parent].point), point(visit.point)});
}

}  // namespace polygonal_perception::planning

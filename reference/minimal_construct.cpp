#include "reference/minimal_construct.hpp"

#include <algorithm>

#include "polygonal_perception/geometry/predicates.hpp"
#include "reference/line_of_sight.hpp"

namespace polygonal_perception::reference {

using geometry::orientation;
using geometry::Orientation;

namespace {

constexpr std::uint32_t kStart = 0;
constexpr std::uint32_t kGoal = 1;

}  // namespace

MinimalConstruct::MinimalConstruct(const geometry::PolygonSet& obstacles) : obstacles_(obstacles)
{
  for (std::size_t r = 0; r < obstacles.rings.size(); ++r) {
    if (!obstacles.rings[r].hole) {
      polygons_.emplace_back();
      polygons_.back().first_ring = r;
    }
    Polygon& polygon = polygons_.back();
    polygon.end_ring = r + 1;
    const geometry::RingView ring = obstacles.view(obstacles.rings[r]);
    for (std::size_t k = 0; k < ring.size(); ++k) {
      polygon.box.extend(ring[k]);
      const Corner corner{ring[ring.previous(k)], ring[k], ring[ring.next(k)]};
      if (orientation(corner.before, corner.at, corner.after) == Orientation::kCounterClockwise)
        polygon.corners.push_back(corner);
    }
  }
}

std::optional<double> MinimalConstruct::plan(const Eigen::Vector2d& start, const Eigen::Vector2d& goal)
{
  tested_lines_ = blocked_lines_ = expanded_vertices_ = 0;
  path_.clear();
  queue_.clear();
  for (Polygon& polygon : polygons_) polygon.is_connected = false;
  vertices_.assign(2, Vertex());
  vertices_[kStart].at = start;
  vertices_[kStart].is_closed = true;
  vertices_[kGoal].at = goal;
  vertices_[kStart].neighbours = {kGoal};
  vertices_[kGoal].neighbours = {kStart};
  setParent(kStart, kGoal);
  while (!queue_.empty()) {
    const Queued next = queue_.front();
    std::pop_heap(queue_.begin(), queue_.end());
    queue_.pop_back();
    const std::uint32_t v = next.vertex;
    Vertex& vertex = vertices_[v];
    if (vertex.is_closed || !vertex.has_parent || vertex.length != next.length ||
        vertex.parent != next.parent)
      continue;
    const std::uint32_t u = vertex.parent;
    ++tested_lines_;
    Polygon* polygon = blocking(vertices_[u].at, vertex.at);
    if (polygon == nullptr) {
      if (v == kGoal) return readPath(v);
      expand(v);
      continue;
    }
    ++blocked_lines_;
    const auto forget = [](std::vector<std::uint32_t>& neighbours, std::uint32_t neighbour) {
      neighbours.erase(std::find(neighbours.begin(), neighbours.end(), neighbour));
    };
    forget(vertex.neighbours, u);
    forget(vertices_[u].neighbours, v);
    vertex.has_parent = false;
    findParent(v);
    if (!polygon->is_connected) connect(*polygon);
  }
  return std::nullopt;
}

MinimalConstruct::Polygon* MinimalConstruct::blocking(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
  Polygon* nearest = nullptr;
  double least = 2.0;
  Eigen::AlignedBox2d box(from);
  box.extend(to);
  for (Polygon& polygon : polygons_) {
    if (!box.intersects(polygon.box)) continue;
    for (std::size_t r = polygon.first_ring; r < polygon.end_ring; ++r) {
      const auto share = blockedAt(obstacles_.view(obstacles_.rings[r]), from, to);
      if (!share || *share >= least) continue;
      least = *share;
      nearest = &polygon;
    }
  }
  return nearest;
}

bool MinimalConstruct::isTangential(const Corner* corner, const Eigen::Vector2d& from)
{
  if (corner == nullptr) return true;
  const Orientation of_before = orientation(from, corner->at, corner->before);
  const Orientation of_after = orientation(from, corner->at, corner->after);
  return of_before == of_after || of_before == Orientation::kCollinear || of_after == Orientation::kCollinear;
}

void MinimalConstruct::setParent(std::uint32_t parent, std::uint32_t vertex)
{
  Vertex& child = vertices_[vertex];
  child.parent = parent;
  child.has_parent = true;
  child.length = vertices_[parent].length + (child.at - vertices_[parent].at).norm();
  queue_.push_back({child.length + (vertices_[kGoal].at - child.at).norm(), vertex, child.length, parent});
  std::push_heap(queue_.begin(), queue_.end());
}

void MinimalConstruct::findParent(std::uint32_t vertex)
{
  const Vertex* nearest = nullptr;
  double least = 0.0;
  for (const std::uint32_t neighbour : vertices_[vertex].neighbours) {
    const Vertex& candidate = vertices_[neighbour];
    if (!candidate.is_closed) continue;
    const double length = candidate.length + (candidate.at - vertices_[vertex].at).norm();
    if (nearest != nullptr && length >= least) continue;
    nearest = &candidate;
    least = length;
  }
  if (nearest != nullptr) setParent(static_cast<std::uint32_t>(nearest - vertices_.data()), vertex);
}

void MinimalConstruct::connect(Polygon& polygon)
{
  polygon.is_connected = true;
  for (const Corner& corner : polygon.corners) {
    const auto index = static_cast<std::uint32_t>(vertices_.size());
    Vertex added;
    added.at = corner.at;
    added.corner = &corner;
    for (std::uint32_t other = 0; other < index; ++other) {
      Vertex& known = vertices_[other];
      if (known.at == corner.at && known.corner != nullptr) continue;
      if (!isTangential(&corner, known.at) || !isTangential(known.corner, corner.at)) continue;
      added.neighbours.push_back(other);
      known.neighbours.push_back(index);
    }
    vertices_.push_back(std::move(added));
    findParent(index);
  }
}

void MinimalConstruct::expand(std::uint32_t vertex)
{
  ++expanded_vertices_;
  vertices_[vertex].is_closed = true;
  for (const std::uint32_t neighbour : vertices_[vertex].neighbours) {
    const Vertex& other = vertices_[neighbour];
    if (other.is_closed) continue;
    const double length = vertices_[vertex].length + (other.at - vertices_[vertex].at).norm();
    if (!other.has_parent || length < other.length) setParent(vertex, neighbour);
  }
}

double MinimalConstruct::readPath(std::uint32_t goal)
{
  for (std::uint32_t at = goal; at != kStart; at = vertices_[at].parent) path_.push_back(vertices_[at].at);
  path_.push_back(vertices_[kStart].at);
  std::reverse(path_.begin(), path_.end());
  return vertices_[goal].length;
}

std::size_t MinimalConstruct::countEdges() const
{
  std::vector<const Corner*> corners;
  for (const Polygon& polygon : polygons_)
    for (const Corner& corner : polygon.corners) corners.push_back(&corner);
  const auto sees = [this](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    return std::none_of(obstacles_.rings.begin(), obstacles_.rings.end(), [&](const auto& ring) {
      return blockedAt(obstacles_.view(ring), from, to).has_value();
    });
  };
  std::size_t count = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t j = i + 1; j < corners.size(); ++j)
      if (isTangential(corners[i], corners[j]->at) && isTangential(corners[j], corners[i]->at) &&
          sees(corners[i]->at, corners[j]->at))
        ++count;
  return count;
}

}  // namespace polygonal_perception::reference

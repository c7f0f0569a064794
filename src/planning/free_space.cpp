#include "polygonal_perception/planning/free_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "polygonal_perception/geometry/mesh_location.hpp"
#include "polygonal_perception/geometry/predicates.hpp"

namespace polygonal_perception::planning {

using geometry::Orientation;
using geometry::TriangleMesh;

namespace {

constexpr std::size_t kFirst = geometry::ConstrainedTriangulation::kSquareCorners;  // vertex of an obstacle

/// Of obstacles of which somewhere more holes than boundaries lie.
geometry::TriangulationFault nestingFault(const geometry::PolygonSet& obstacles)
{
  for (std::uint32_t i = 0; i < obstacles.rings.size(); ++i) {
    const geometry::PolygonSet::Ring& ring = obstacles.rings[i];
    const Orientation wrong = ring.hole ? Orientation::kCounterClockwise : Orientation::kClockwise;
    if (geometry::orientation(obstacles.view(ring)) != wrong) continue;
    return {i, obstacles.vertices[ring.first],
            "ring " + std::to_string(i) +
                (ring.hole ? ", a hole, runs counter-clockwise" : ", a boundary, runs clockwise")};
  }
  return {0, Eigen::Vector2d::Zero(), "a hole lies outside of its boundary"};
}

}  // namespace

std::optional<geometry::TriangulationFault> FreeSpace::build(const geometry::PolygonSet& obstacles,
                                                             bool everything_is_blocked)
{
  auto fault = triangulation_.triangulate(obstacles, mesh_);
  if (!fault && !findDepths(everything_is_blocked ? 1 : 0)) fault = nestingFault(obstacles);
  if (fault) {
    mesh_.clear();
    box_.setEmpty();
    return fault;
  }
  box_ = Eigen::AlignedBox2d(mesh_.vertices[0], mesh_.vertices[2]);
  findRegions();
  findCorners();
  fillGrid();
  return std::nullopt;
}

bool FreeSpace::findDepths(std::int32_t outside)
{
  // Outwards in, from the square's border.
  constexpr std::int32_t kUnknown = std::numeric_limits<std::int32_t>::min();
  depth_.assign(mesh_.triangleCount(), kUnknown);
  queue_.assign(1, mesh_.outgoing[0]);
  depth_[queue_[0] / 3] = outside;
  while (!queue_.empty()) {
    std::uint32_t edge = queue_.back();
    queue_.pop_back();
    const std::int32_t depth = depth_[edge / 3];
    for (int i = 0; i < 3; ++i, edge = TriangleMesh::next(edge)) {
      const std::uint32_t twin = mesh_.twin(edge);
      if (twin == TriangleMesh::kNone || depth_[twin / 3] != kUnknown) continue;
      depth_[twin / 3] = depth + mesh_.half_edges[twin].step;
      if (depth_[twin / 3] < 0) return false;
      queue_.push_back(twin);
    }
  }
  return true;
}

void FreeSpace::findRegions()
{
  region_.assign(mesh_.triangleCount(), TriangleMesh::kNone);
  std::uint32_t count = 0;
  for (std::uint32_t first = 0; first < region_.size(); ++first) {
    if (depth_[first] != 0 || region_[first] != TriangleMesh::kNone) continue;
    region_[first] = count;
    queue_.assign(1, 3 * first);
    while (!queue_.empty()) {
      std::uint32_t edge = queue_.back();
      queue_.pop_back();
      for (int i = 0; i < 3; ++i, edge = TriangleMesh::next(edge)) {
        if (!isOpen(edge)) continue;
        const std::uint32_t twin = mesh_.twin(edge);
        if (region_[twin / 3] != TriangleMesh::kNone) continue;
        region_[twin / 3] = count;
        queue_.push_back(twin);
      }
    }
    ++count;
  }
}

void FreeSpace::findCorners()
{
  corners_.clear();
  corner_of_.assign(mesh_.half_edges.size(), TriangleMesh::kNone);
  for (std::uint32_t first = 0; first < mesh_.half_edges.size(); ++first) {
    if (!mesh_.half_edges[first].constrained || !isFree(first)) continue;
    std::uint32_t last = first;
    while (isOpen(TriangleMesh::previous(last))) last = mesh_.nextAround(last);
    const std::uint32_t vertex = mesh_.origin(first);
    const Corner corner{mesh_.target(first), mesh_.apex(last)};
    const Eigen::Vector2d& at = mesh_.vertices[vertex];
    const Eigen::Vector2d& from = mesh_.vertices[corner.first];
    const Eigen::Vector2d& to = mesh_.vertices[corner.last];
    const Orientation turn = geometry::orientation(at, from, to);
    // A whole turn is around the end of something without a width.
    const bool wide = turn == Orientation::kClockwise ||
                      (turn == Orientation::kCollinear && (from - at).dot(to - at) > 0.0);
    if (!wide) continue;
    const auto index = static_cast<std::uint32_t>(corners_.size());
    corners_.push_back(corner);
    for (std::uint32_t spoke = first;; spoke = mesh_.nextAround(spoke)) {
      corner_of_[spoke] = index;
      if (spoke == last) break;
    }
  }
}

void FreeSpace::fillGrid()
{
  grid_box_.setEmpty();
  for (std::size_t i = kFirst; i < mesh_.vertices.size(); ++i) grid_box_.extend(mesh_.vertices[i]);
  if (grid_box_.isEmpty()) grid_box_ = Eigen::AlignedBox2d(Eigen::Vector2d::Zero());
  // About two vertices a cell.
  const Eigen::Vector2d size = grid_box_.sizes().cwiseMax(1e-6);
  cell_size_ = std::max(std::sqrt(2.0 * size.x() * size.y() / static_cast<double>(mesh_.vertices.size())),
                        size.maxCoeff() / 1024.0);
  columns_ = static_cast<std::uint32_t>(size.x() / cell_size_) + 1;
  rows_ = static_cast<std::uint32_t>(size.y() / cell_size_) + 1;
  grid_.assign(std::size_t{columns_} * rows_, TriangleMesh::kNone);
  for (std::size_t i = kFirst; i < mesh_.vertices.size(); ++i) {
    const Eigen::Vector2d cell = (mesh_.vertices[i] - grid_box_.min()) / cell_size_;
    grid_[static_cast<std::size_t>(cell.y()) * columns_ + static_cast<std::size_t>(cell.x())] =
        mesh_.outgoing[i];
  }
  std::uint32_t near = mesh_.outgoing[mesh_.vertices.size() - 1];
  for (std::uint32_t& half_edge : grid_) {
    if (half_edge == TriangleMesh::kNone) half_edge = near;
    near = half_edge;
  }
}

std::optional<FreePlace> FreeSpace::locate(const Eigen::Vector2d& point) const
{
  if (!covers(point)) return std::nullopt;
  const Eigen::Vector2d cell = ((point - grid_box_.min()) / cell_size_).cwiseMax(0.0);
  const auto column = static_cast<std::size_t>(std::min(cell.x(), columns_ - 1.0));
  const auto row = static_cast<std::size_t>(std::min(cell.y(), rows_ - 1.0));
  const geometry::MeshPlace place = geometry::locate(mesh_, point, grid_[row * columns_ + column]);
  FreePlace free{point, place.half_edge, place.on_edge, place.at_origin};
  if (place.at_origin) {
    const std::uint32_t first = free.half_edge;
    while (!isFree(free.half_edge)) {
      free.half_edge = mesh_.nextAround(free.half_edge);
      if (free.half_edge == first) return std::nullopt;
    }
  } else if (!isFree(free.half_edge)) {
    if (!free.on_edge || !isFree(mesh_.twin(free.half_edge))) return std::nullopt;
    free.half_edge = mesh_.twin(free.half_edge);
  }
  return free;
}

std::optional<FreePlace> FreeSpace::nearest(const Eigen::Vector2d& point, std::uint32_t region) const
{
  std::optional<FreePlace> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t edge = 0; edge < mesh_.half_edges.size(); ++edge) {
    if (!mesh_.half_edges[edge].constrained || !isFree(edge)) continue;
    if (region != TriangleMesh::kNone && region_[edge / 3] != region) continue;
    const Eigen::Vector2d& from = mesh_.originPoint(edge);
    const Eigen::Vector2d along = mesh_.targetPoint(edge) - from;
    const double share = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    const Eigen::Vector2d place = from + share * along;
    const double distance = (point - place).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    if (share == 1.0)
      nearest = FreePlace{mesh_.targetPoint(edge), TriangleMesh::next(edge), true, true};
    else
      nearest = FreePlace{place, edge, true, share == 0.0};
  }
  return nearest;
}

}  // namespace polygonal_perception::planning

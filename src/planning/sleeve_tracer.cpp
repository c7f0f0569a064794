#include "polygonal_perception/planning/sleeve_tracer.hpp"

#include "planning/interval_length.hpp"
#include "polygonal_perception/geometry/predicates.hpp"

namespace polygonal_perception::planning {

using geometry::orientation;
using geometry::Orientation;
using geometry::TriangleMesh;

bool SleeveTracer::trace(const FreeSpace& space, const FreePlace& start, const FreePlace& goal,
                         const std::vector<Eigen::Vector2d>& line, Sleeve& sleeve)
{
  sleeve.clear();
  const auto first = firstTriangle(space, start, line.size() > 1 ? line[1] : line[0]);
  if (!first || !crossTriangles(space.mesh(), *first, goal.half_edge, line)) return false;
  sleeve.first = *first;
  for (std::size_t i = 0; i < crossings_.size(); ++i) {
    if (space.isOpen(crossings_[i].half_edge)) {
      sleeve.cross(crossings_[i].half_edge, space.mesh());
      continue;
    }
    const std::size_t entry = i;
    while (!space.isFree(space.mesh().twin(crossings_[i].half_edge)))
      if (++i == crossings_.size()) return false;
    if (!goRound(space, crossings_[entry], crossings_[i], sleeve)) return false;
  }
  return true;
}

std::optional<std::uint32_t> SleeveTracer::firstTriangle(const FreeSpace& space, const FreePlace& start,
                                                         const Eigen::Vector2d& towards) const
{
  const TriangleMesh& mesh = space.mesh();
  if (!start.at_origin) return start.half_edge;
  // Of those around the vertex the one that the line goes into.
  std::optional<std::uint32_t> first;
  space.forEachTriangleAt(start, [&](std::uint32_t spoke) {
    const Orientation of_target = orientation(start.point, towards, mesh.targetPoint(spoke));
    const Orientation of_apex = orientation(start.point, towards, mesh.apexPoint(spoke));
    if (of_target != Orientation::kCounterClockwise && of_apex == Orientation::kCounterClockwise)
      first = spoke;
  });
  return first;
}

bool SleeveTracer::crossTriangles(const TriangleMesh& mesh, std::uint32_t first, std::uint32_t last,
                                  const std::vector<Eigen::Vector2d>& line)
{
  crossings_.clear();
  std::uint32_t at = first;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Eigen::Vector2d& from = line[i];
    const Eigen::Vector2d& to = line[i + 1];
    // A vertex on the line counts as one to the left of it: the line passes it, whatever it touches.
    const auto isRight = [&](std::uint32_t vertex) {
      return orientation(from, to, mesh.vertices[vertex]) == Orientation::kClockwise;
    };
    const bool is_last = i + 2 == line.size();
    for (;;) {
      // A goal on an obstacle's border may lie beyond it by rounding.
      if (is_last && TriangleMesh::triangleOf(at) == TriangleMesh::triangleOf(last)) break;
      bool has_arrived = true;
      std::uint32_t crossed = TriangleMesh::kNone;
      for (int side = 0; side < 3; ++side, at = TriangleMesh::next(at)) {
        if (orientation(mesh.originPoint(at), mesh.targetPoint(at), to) != Orientation::kClockwise) continue;
        has_arrived = false;
        if (isRight(mesh.origin(at)) && !isRight(mesh.target(at))) crossed = at;
      }
      if (has_arrived) break;
      if (crossed == TriangleMesh::kNone || mesh.twin(crossed) == TriangleMesh::kNone) return false;
      crossings_.push_back(
          {crossed, lineCrossing(from, to, mesh.originPoint(crossed), mesh.targetPoint(crossed))});
      at = mesh.twin(crossed);
    }
  }
  return true;
}

bool SleeveTracer::goRound(const FreeSpace& space, const Crossing& entry, const Crossing& exit,
                           Sleeve& sleeve)
{
  const Crossing out{space.mesh().twin(exit.half_edge), exit.place};
  if (!followBorder(space, entry, out, true, forward_)) return false;
  if (!followBorder(space, entry, out, false, backward_)) return false;
  const Detour& shorter = forward_.length < backward_.length ? forward_ : backward_;
  for (const std::uint32_t half_edge : shorter.crossed) sleeve.cross(half_edge, space.mesh());
  return true;
}

bool SleeveTracer::followBorder(const FreeSpace& space, const Crossing& entry, const Crossing& exit,
                                bool forward, Detour& detour)
{
  const TriangleMesh& mesh = space.mesh();
  detour.crossed.clear();
  detour.length = 0.0;
  const auto end = [&](std::uint32_t edge) {
    return forward ? mesh.targetPoint(edge) : mesh.originPoint(edge);
  };
  Eigen::Vector2d at = entry.place;
  std::uint32_t border = entry.half_edge;
  do {
    detour.length += (end(border) - at).norm();
    at = end(border);
    // Around the border's end, through the triangles there.
    border = forward ? TriangleMesh::next(border) : TriangleMesh::previous(border);
    while (space.isOpen(border)) {
      detour.crossed.push_back(border);
      const std::uint32_t beyond = mesh.twin(border);
      border = forward ? TriangleMesh::next(beyond) : TriangleMesh::previous(beyond);
    }
    if (border == exit.half_edge) {
      detour.length += (exit.place - at).norm();
      return true;
    }
  } while (border != entry.half_edge);
  return false;
}

}  // namespace polygonal_perception::planning

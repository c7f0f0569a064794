#include "perception/segmentation/piece_boundary.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>

namespace polygonal_perception::perception {

namespace {

/// Where a line of sight from the origin meets a plane; nothing where it runs beside it.
std::optional<Eigen::Vector3f> meet(const ReferencePlane& plane, const Eigen::Vector3f& sight)
{
  const float along = plane.normal.dot(sight);
  if (!(along * plane.distance < 0.0F)) return std::nullopt;
  return Eigen::Vector3f(-plane.distance / along * sight);
}

}  // namespace

void PieceBoundary::trace(const PointView& points, const SampleGrid& grid, const PlaneLookup& lookup,
                          const std::uint32_t* cells, const PlanePieces::Piece& piece,
                          const geometry::Plane& plane, std::vector<Eigen::Vector3f>& vertices)
{
  cells_.reset(grid.samplesX(), grid.samplesY());
  for (const std::uint32_t* cell = cells + piece.first; cell != cells + piece.first + piece.size; ++cell) {
    const int x = static_cast<int>(*cell) % grid.samplesX();
    const int y = static_cast<int>(*cell) / grid.samplesX();
    cells_.row(y)[x / occupancy::BitGrid::kWordBits] |= std::uint64_t{1}
                                                        << (x % occupancy::BitGrid::kWordBits);
  }
  tracer_.trace(cells_, outlines_);
  const auto boundary = std::find_if(outlines_.rings.begin(), outlines_.rings.end(),
                                     [](const occupancy::Outlines::Ring& ring) { return !ring.hole; });
  if (boundary == outlines_.rings.end()) return;
  collectEdges(*boundary);

  const ReferencePlane reference(plane);
  const std::size_t first = vertices.size();
  for (const Edge& edge : edges_) {
    const auto last = lastPoint(points, grid, lookup, static_cast<int>(piece.plane), edge);
    if (!last) continue;
    const auto vertex = meet(reference, *last);
    // At a corner of the image two edges end in one pixel.
    if (vertex && (vertices.size() == first || vertices.back() != *vertex)) vertices.push_back(*vertex);
  }
  if (vertices.size() > first + 1 && vertices.back() == vertices[first]) vertices.pop_back();
  // In the image y points down: what runs counter-clockwise in the grid is clockwise to the camera.
  std::reverse(vertices.begin() + static_cast<std::ptrdiff_t>(first), vertices.end());
}

/// The last point of the plane on the way from a cell over its edge; nothing for a cell that was bridged, which is before
/// the plane.
std::optional<Eigen::Vector3f> PieceBoundary::lastPoint(const PointView& points, const SampleGrid& grid,
                                                        const PlaneLookup& lookup, int plane,
                                                        const Edge& edge)
{
  const auto index = static_cast<std::size_t>(edge.y) * static_cast<std::size_t>(grid.samplesX()) +
                     static_cast<std::size_t>(edge.x);
  const Sample& sample = grid.samples()[index];
  if (!sample.has_point || lookup.planeOf(index, sample.point).plane != plane) return std::nullopt;
  Eigen::Vector3f last = sample.point;
  const int x = edge.x + edge.dy;
  const int y = edge.y - edge.dx;
  if (x < 0 || y < 0 || x >= grid.samplesX() || y >= grid.samplesY()) return last;
  int u = sample.u;
  int v = sample.v;
  int beyond_u = grid.at(x, y).u;
  int beyond_v = grid.at(x, y).v;
  while (std::max(std::abs(beyond_u - u), std::abs(beyond_v - v)) > 1) {
    const int middle_u = (u + beyond_u) / 2;
    const int middle_v = (v + beyond_v) / 2;
    const Eigen::Vector3f point =
        points.point(static_cast<std::uint32_t>(middle_u), static_cast<std::uint32_t>(middle_v));
    const bool is_on = lookup.planeOf(index, point).plane == plane;
    if (is_on) last = point;
    (is_on ? u : beyond_u) = middle_u;
    (is_on ? v : beyond_v) = middle_v;
  }
  return last;
}

void PieceBoundary::collectEdges(const occupancy::Outlines::Ring& ring)
{
  // To the whole corner: where cells touch in a corner, outlines give way by less than half a cell.
  const auto toCell = [](std::int32_t units) {
    return static_cast<int>((units + occupancy::kUnitsPerCell / 2) / occupancy::kUnitsPerCell);
  };
  edges_.clear();
  std::uint32_t at = ring.start;
  do {
    const std::uint32_t next = outlines_.vertices[at].next;
    int x = toCell(outlines_.vertices[at].at.x);
    int y = toCell(outlines_.vertices[at].at.y);
    const int to_x = toCell(outlines_.vertices[next].at.x);
    const int to_y = toCell(outlines_.vertices[next].at.y);
    const int dx = (to_x > x) - (to_x < x);
    const int dy = (to_y > y) - (to_y < y);
    for (; x != to_x || y != to_y; x += dx, y += dy) {
      const int cell_x = dx != 0 ? std::min(x, x + dx) : (dy > 0 ? x - 1 : x);
      const int cell_y = dy != 0 ? std::min(y, y + dy) : (dx > 0 ? y : y - 1);
      edges_.push_back({cell_x, cell_y, dx, dy});
    }
    at = next;
  } while (at != ring.start);
}

}  // namespace polygonal_perception::perception

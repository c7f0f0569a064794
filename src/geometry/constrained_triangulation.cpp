#include "polygonal_perception/geometry/constrained_triangulation.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "geometry/segment_insertion.hpp"
#include "geometry/vertex_insertion.hpp"

namespace polygonal_perception::geometry {

namespace {

constexpr double kFarthest = 1e8;             // [m]
constexpr double kNearest = 1e-100;           // [m] to an axis, but on it: smaller products underflow
constexpr std::size_t kCrossingsAVertex = 4;  // this package's polygons have none; many take n squared

TriangulationFault fault(std::uint32_t ring, const Eigen::Vector2d& place, const char* what)
{
  char text[160];
  std::snprintf(text, sizeof text, "ring %u %s at (%.9g, %.9g)", ring, what, place.x(), place.y());
  return {ring, place, text};
}

/// What the predicates decide exactly. Written so that NaN is not.
bool isInRange(double coordinate)
{
  const double magnitude = std::abs(coordinate);
  return magnitude == 0.0 || (magnitude >= kNearest && magnitude <= kFarthest);
}

/// Where a cell lies on Hilbert's curve through 2^16 x 2^16 cells: neighbours on it are neighbours in the plane.
std::uint64_t hilbert(std::uint32_t x, std::uint32_t y)
{
  std::uint64_t key = 0;
  for (std::uint32_t s = 1U << 15U; s > 0; s >>= 1U) {
    const std::uint32_t right = (x & s) != 0 ? 1 : 0;
    const std::uint32_t up = (y & s) != 0 ? 1 : 0;
    key = key * 4 + ((3 * right) ^ up);
    if (up == 0) {
      if (right == 1) {
        x = ~x;
        y = ~y;
      }
      std::swap(x, y);
    }
  }
  return key;
}

}  // namespace

std::optional<TriangulationFault> ConstrainedTriangulation::triangulate(const PolygonSet& polygons,
                                                                        TriangleMesh& mesh)
{
  Eigen::AlignedBox2d box;
  for (std::uint32_t r = 0; r < polygons.rings.size(); ++r) {
    for (const Eigen::Vector2d& vertex : polygons.view(polygons.rings[r])) {
      if (!isInRange(vertex.x()) || !isInRange(vertex.y()))
        return fault(r, vertex, "has a number that is not 0 or from 10^-100 to 10^8 m");
      box.extend(vertex);
    }
  }
  if (box.isEmpty()) box.extend(Eigen::Vector2d::Zero());
  const double size = box.sizes().maxCoeff();
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(0.5 * size + std::max(kLeastMargin, kMargin * size));
  MeshEditor(mesh).beginWithSquare(box.center() - half, box.center() + half);

  // In an order in which each vertex is near the one before.
  const double scale = 65535.0 / std::max(size, 1e-9);
  order_.clear();
  for (const PolygonSet::Ring& ring : polygons.rings) {
    for (std::uint32_t i = ring.first; i < ring.first + ring.size; ++i) {
      const Eigen::Vector2d cell = (polygons.vertices[i] - box.min()) * scale;
      order_.push_back(
          {hilbert(static_cast<std::uint32_t>(cell.x()), static_cast<std::uint32_t>(cell.y())), i});
    }
  }
  std::sort(order_.begin(), order_.end(), [](const Keyed& a, const Keyed& b) { return a.key < b.key; });
  mesh_vertices_.assign(polygons.vertices.size(), TriangleMesh::kNone);
  VertexInsertion vertices(mesh, scratch_);
  for (const Keyed& keyed : order_)
    mesh_vertices_[keyed.vertex] = vertices.insert(polygons.vertices[keyed.vertex]);

  SegmentInsertion segments(mesh, kCrossingsAVertex * polygons.vertices.size(), {edge_scratch_, scratch_});
  for (std::uint32_t r = 0; r < polygons.rings.size(); ++r) {
    const PolygonSet::Ring& ring = polygons.rings[r];
    for (std::uint32_t i = 0; i < ring.size; ++i) {
      const std::uint32_t from = mesh_vertices_[ring.first + i];
      const std::uint32_t to = mesh_vertices_[ring.first + (i + 1 == ring.size ? 0 : i + 1)];
      if (const auto place = segments.insert(from, to, 1))
        return fault(r, *place, "crosses another edge too closely or too often");
    }
  }
  return std::nullopt;
}

}  // namespace polygonal_perception::geometry

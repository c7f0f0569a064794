#include "polygonal_perception/geometry/mesh_location.hpp"

#include <array>

#include "polygonal_perception/geometry/predicates.hpp"

namespace polygonal_perception::geometry {

MeshPlace locate(const TriangleMesh& mesh, const Eigen::Vector2d& point, std::uint32_t start)
{
  std::uint32_t half_edge = start;
  // A walk that always looked at the same edge first could go in circles, outside of Delaunay's triangulations. One that
  // draws lots ends (Devillers, Pion and Teillaud, Walking in a triangulation, 2002).
  std::uint32_t lot = 1;
  for (;;) {
    lot = lot * 1664525U + 1013904223U;
    if ((lot & 0x80000000U) != 0) half_edge = TriangleMesh::next(half_edge);
    std::array<Orientation, 3> sides{};
    std::uint32_t edge = half_edge;
    std::uint32_t beyond = TriangleMesh::kNone;
    for (Orientation& side : sides) {
      side = orientation(mesh.originPoint(edge), mesh.targetPoint(edge), point);
      if (side == Orientation::kClockwise && mesh.twin(edge) != TriangleMesh::kNone) {
        beyond = mesh.twin(edge);
        break;
      }
      edge = TriangleMesh::next(edge);
    }
    if (beyond != TriangleMesh::kNone) {
      // The edge that was crossed is the last to be looked at: the point lies on this side of it.
      half_edge = TriangleMesh::next(beyond);
      continue;
    }
    for (const Orientation side : sides) {
      if (side == Orientation::kCollinear) {
        if (mesh.originPoint(edge) == point) return {edge, true, true};
        if (mesh.targetPoint(edge) == point) return {TriangleMesh::next(edge), true, true};
        return {edge, true, false};
      }
      edge = TriangleMesh::next(edge);
    }
    return {edge, false, false};
  }
}

}  // namespace polygonal_perception::geometry

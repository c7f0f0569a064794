#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/triangle_mesh.hpp"

namespace polygonal_perception::geometry {

/// Where a point is in a mesh.
struct MeshPlace
{
  std::uint32_t half_edge = TriangleMesh::kNone;  ///< of a triangle that contains it, border included
  bool on_edge = false;                           ///< it lies on that half-edge
  bool at_origin = false;                         ///< it is that half-edge's origin
};

/// Walks from a triangle to one that contains a point. The farther the start, the longer it takes.
///
/// @param point  in the region that the mesh covers; for others the answer means nothing
/// @param start  a half-edge of the triangle to begin with
POLYGONAL_PERCEPTION_EXPORT MeshPlace locate(const TriangleMesh& mesh, const Eigen::Vector2d& point,
                                             std::uint32_t start);

}  // namespace polygonal_perception::geometry

#pragma once

#include "geometry/mesh_editor.hpp"

namespace polygonal_perception::geometry {

/// Adds points to a triangulation that has no constrained edges yet, and keeps it Delaunay's but for points that lie on
/// one circle within rounding.
class VertexInsertion
{
public:
  /// @param scratch  memory, to be used again
  VertexInsertion(TriangleMesh& mesh, std::vector<std::uint32_t>& scratch)
      : mesh_(mesh), editor_(mesh), doubtful_(scratch)
  {
  }

  /// @param point  inside the mesh's region
  /// @return the vertex there; one that has been there before where it has the same coordinates
  std::uint32_t insert(const Eigen::Vector2d& point);

private:
  void makeDelaunay(std::uint32_t vertex);

  TriangleMesh& mesh_;
  MeshEditor editor_;
  std::uint32_t last_ = 0;                // a half-edge near the last point
  std::vector<std::uint32_t>& doubtful_;  // half-edges that may have to be flipped
};

}  // namespace polygonal_perception::geometry

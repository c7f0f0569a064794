#pragma once

#include <cstdint>
#include <vector>

#include "polygonal_perception/geometry/triangle_mesh.hpp"

namespace polygonal_perception::planning {

/// The triangles through which a line goes, one after the other. All lines through the same sleeve pass each obstacle on the
/// same side: they are homotopic.
struct Sleeve
{
  std::uint32_t first = geometry::TriangleMesh::kNone;  ///< a half-edge of the triangle in which it begins
  /// Half-edges of the triangle that is left, each across an open edge.
  std::vector<std::uint32_t> crossed;

  void clear()
  {
    first = geometry::TriangleMesh::kNone;
    crossed.clear();
  }
  /// Goes on across an edge. Who goes back at once has not been there.
  void cross(std::uint32_t half_edge, const geometry::TriangleMesh& mesh)
  {
    if (!crossed.empty() && mesh.twin(crossed.back()) == half_edge)
      crossed.pop_back();
    else
      crossed.push_back(half_edge);
  }
};

}  // namespace polygonal_perception::planning

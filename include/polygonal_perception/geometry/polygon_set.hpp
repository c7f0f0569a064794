#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace polygonal_perception::geometry {

/// The obstacles of a frame: polygons with holes, all their vertices in one array, so that a set that is
/// filled again and again stops allocating.
///
/// A boundary runs counter-clockwise seen from above, a hole clockwise; the first vertex is not repeated.
struct PolygonSet
{
  struct Ring
  {
    std::uint32_t first = 0;  ///< index of its first vertex
    std::uint32_t size = 0;   ///< number of its vertices, at least 3
    bool hole = false;        ///< a hole of the last boundary before it
  };

  std::vector<Eigen::Vector2d> vertices;  ///< [m] in the floor frame
  std::vector<Ring> rings;                ///< each boundary is followed by its holes

  void clear()
  {
    vertices.clear();
    rings.clear();
  }
};

}  // namespace polygonal_perception::geometry

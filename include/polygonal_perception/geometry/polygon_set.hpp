#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "polygonal_perception/geometry/ring_view.hpp"

namespace polygonal_perception::geometry {

/// Polygons with holes, all their vertices in one array, so that a set that is filled again and again stops
/// allocating.
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

  std::vector<Eigen::Vector2d> vertices;  ///< [m] in the frame of whoever filled it
  std::vector<Ring> rings;                ///< each boundary is followed by its holes

  void clear()
  {
    vertices.clear();
    rings.clear();
  }

  /// The vertices and edges of one of `rings`; good until `vertices` changes.
  RingView view(const Ring& ring) const { return {vertices.data() + ring.first, ring.size}; }

  /// Copies a ring that is not of this set to the end of it.
  void append(const RingView& ring, bool hole)
  {
    rings.push_back(
        {static_cast<std::uint32_t>(vertices.size()), static_cast<std::uint32_t>(ring.size()), hole});
    vertices.insert(vertices.end(), ring.begin(), ring.end());
  }
};

}  // namespace polygonal_perception::geometry

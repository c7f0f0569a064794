#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/polygon_set.hpp"
#include "polygonal_perception/geometry/triangle_mesh.hpp"

namespace polygonal_perception::geometry {

/// Why polygons cannot be triangulated.
struct TriangulationFault
{
  std::uint32_t ring;     ///< index into PolygonSet::rings
  Eigen::Vector2d place;  ///< [m] where to look
  std::string text;       ///< a sentence with the ring, the place and what is wrong
};

/// A constrained Delaunay triangulation: of a square around some polygons, in which each of their edges is an edge, or a
/// chain of edges, of triangles. Signs are exact, so that no edge passes a vertex on the wrong side.
///
/// Rings may touch each other and themselves. Where they cross, the crossing becomes a vertex, within rounding. The time is
/// near n log n for n vertices.
class POLYGONAL_PERCEPTION_EXPORT ConstrainedTriangulation
{
public:
  /// How far the square reaches beyond the polygons, as a multiple of their extent, and at least [m]: so far that a robot is
  /// in it whatever it sees. The distance costs nothing, for signs are exact.
  static constexpr double kMargin = 100.0;
  static constexpr double kLeastMargin = 1000.0;
  /// The mesh's first vertices are the square's corners.
  static constexpr std::uint32_t kSquareCorners = 4;

  /// @param mesh  replaced; unspecified where the polygons are refused. Its memory is used again
  /// @return nothing; or the reason: a coordinate that is not 0 or of 10^-100 to 10^8 m, rings that cross each other more often
  ///         than four times their vertices, or so near to a vertex that double precision cannot tell them apart
  std::optional<TriangulationFault> triangulate(const PolygonSet& polygons, TriangleMesh& mesh);

private:
  struct Keyed
  {
    std::uint64_t key;
    std::uint32_t vertex;
  };
  std::vector<Keyed> order_;
  std::vector<std::uint32_t> mesh_vertices_;  // of each vertex of the polygons
  std::vector<std::uint32_t> scratch_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edge_scratch_;
};

}  // namespace polygonal_perception::geometry

#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/constrained_triangulation.hpp"
#include "polygonal_perception/geometry/polygon_set.hpp"
#include "polygonal_perception/geometry/triangle_mesh.hpp"

namespace polygonal_perception::planning {

/// Where a point is, as seen by somebody who may stand there.
struct FreePlace
{
  Eigen::Vector2d point = Eigen::Vector2d::Zero();  ///< [m]
  /// A half-edge of a free triangle that contains the point, border included.
  std::uint32_t half_edge = geometry::TriangleMesh::kNone;
  bool on_edge = false;    ///< the point lies on that half-edge, or within rounding of it
  bool at_origin = false;  ///< it is that half-edge's origin
};

/// What is left of the plane beside obstacles: triangles, and the corners around which a path can bend. Made once for a
/// polygon set, for many queries.
class POLYGONAL_PERCEPTION_EXPORT FreeSpace
{
public:
  /// The free triangles around a vertex between two edges of obstacles, more than half a turn wide: a taut path bends in
  /// it, around the obstacle that fills the rest (a convex corner, Minimal Construct, section III).
  struct Corner
  {
    std::uint32_t first =
        0;  ///< other end of the edge at its clockwise end: the obstacle is to the right of who leaves by it
    std::uint32_t last = 0;  ///< and of the edge at its counter-clockwise end
  };

  /// Replaces the obstacles. Memory is used again.
  ///
  /// @param obstacles  polygons that may touch, overlap and cross; their borders are free
  /// @param everything_is_blocked  but for what a hole without a boundary of its own leaves open
  /// @return nothing; or why they are refused, and then there is no free space at all: see ConstrainedTriangulation, and
  ///         rings that run the wrong way
  std::optional<geometry::TriangulationFault> build(const geometry::PolygonSet& obstacles,
                                                    bool everything_is_blocked = false);

  /// The place of a point that is free; nothing where it is inside an obstacle or beyond the square that the mesh covers.
  std::optional<FreePlace> locate(const Eigen::Vector2d& point) const;

  /// The nearest free place to a point inside an obstacle: a point of an obstacle's border. O(edges).
  ///
  /// @param region  only places of this one; kNone: of any
  /// @return nothing where there is none
  std::optional<FreePlace> nearest(const Eigen::Vector2d& point,
                                   std::uint32_t region = geometry::TriangleMesh::kNone) const;

  /// The connected region of free space that the triangle of a half-edge is part of. No way leads from one to another, since
  /// none leads through a point in which obstacles touch.
  std::uint32_t region(std::uint32_t half_edge) const { return region_[half_edge / 3]; }
  /// Calls `take` with a half-edge of each free triangle that contains a place: one, two on an edge, or those around a vertex.
  template <class Take>
  void forEachTriangleAt(const FreePlace& place, Take&& take) const
  {
    take(place.half_edge);
    if (place.at_origin) {
      for (std::uint32_t spoke = mesh_.nextAround(place.half_edge);
           spoke != place.half_edge && spoke != geometry::TriangleMesh::kNone;
           spoke = mesh_.nextAround(spoke)) {
        if (isFree(spoke)) take(spoke);
      }
    } else if (place.on_edge && isOpen(place.half_edge)) {
      take(mesh_.twin(place.half_edge));
    }
  }

  const geometry::TriangleMesh& mesh() const { return mesh_; }
  bool isFree(std::uint32_t half_edge) const { return depth_[half_edge / 3] == 0; }
  /// Whether one can cross a half-edge of a free triangle.
  bool isOpen(std::uint32_t half_edge) const
  {
    const auto& edge = mesh_.half_edges[half_edge];
    return !edge.constrained && edge.twin != geometry::TriangleMesh::kNone;
  }
  /// The corner that a half-edge's origin is, seen from the half-edge's triangle; null where it is none.
  const Corner* corner(std::uint32_t half_edge) const
  {
    const std::uint32_t index = corner_of_[half_edge];
    return index == geometry::TriangleMesh::kNone ? nullptr : &corners_[index];
  }
  /// Whether a point lies inside the square that the mesh covers. NaN does not.
  bool covers(const Eigen::Vector2d& point) const
  {
    return (point.array() > box_.min().array()).all() && (point.array() < box_.max().array()).all();
  }

private:
  bool findDepths(std::int32_t outside);
  void findRegions();
  void findCorners();
  void fillGrid();

  geometry::ConstrainedTriangulation triangulation_;
  geometry::TriangleMesh mesh_;
  Eigen::AlignedBox2d box_;
  std::vector<std::int32_t> depth_;    // of each triangle: how many polygons contain it
  std::vector<std::uint32_t> region_;  // of each triangle that is free
  std::vector<Corner> corners_;
  std::vector<std::uint32_t> corner_of_;  // of each half-edge
  std::vector<std::uint32_t> queue_;

  // For each cell of a grid over the polygons a half-edge near it, to begin a walk with.
  Eigen::AlignedBox2d grid_box_;
  double cell_size_ = 1.0;  // [m]
  std::uint32_t columns_ = 0;
  std::uint32_t rows_ = 0;
  std::vector<std::uint32_t> grid_;
};

}  // namespace polygonal_perception::planning

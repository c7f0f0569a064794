#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "perception/segmentation/plane_lookup.hpp"
#include "perception/segmentation/plane_pieces.hpp"
#include "polygonal_perception/geometry/plane.hpp"
#include "polygonal_perception/occupancy/grid/bit_grid.hpp"
#include "polygonal_perception/occupancy/polygons/outline_tracer.hpp"
#include "polygonal_perception/occupancy/polygons/outlines.hpp"
#include "polygonal_perception/perception/input/point_view.hpp"
#include "polygonal_perception/perception/planes/sample_grid.hpp"

namespace polygonal_perception::perception {

/// Draws the boundary of a piece of a plane round its samples.
///
/// Where a neighbour of a sample is not of the piece, the pixels between the two are searched for the place where the
/// plane ends. Points of the boundary lie on the plane, in the lines of sight of those pixels, so that this needs nothing
/// of the camera, and works for any organised cloud.
class PieceBoundary
{
public:
  /// @param cells     of all pieces
  /// @param vertices  the ring is appended: on the plane, counter-clockwise as the camera sees it
  void trace(const PointView& points, const SampleGrid& grid, const PlaneLookup& lookup,
             const std::uint32_t* cells, const PlanePieces::Piece& piece, const geometry::Plane& plane,
             std::vector<Eigen::Vector3f>& vertices);

private:
  /// A side of a cell. (dx, dy) is its direction along the ring, the cell lies to its left.
  struct Edge
  {
    int x, y;  // of the cell
    int dx, dy;
  };

  void collectEdges(const occupancy::Outlines::Ring& ring);
  static std::optional<Eigen::Vector3f> lastPoint(const PointView& points, const SampleGrid& grid,
                                                  const PlaneLookup& lookup, int plane, const Edge& edge);

  occupancy::BitGrid cells_;
  occupancy::OutlineTracer tracer_;
  occupancy::Outlines outlines_;
  std::vector<Edge> edges_;  // of the ring, between a cell of the piece and one that is not of it
};

}  // namespace polygonal_perception::perception

#pragma once

#include <Eigen/Core>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/polygon_set.hpp"

namespace polygonal_perception::geometry {

/// Cuts polygons with holes into triangles, to be drawn.
///
/// A line sweeps over the polygons and cuts them into trapezoids between their edges. Unlike ear clipping it
/// minds neither rings that touch nor corners in one line, of which polygons made of grid cells are full.
/// Where rings cross (which breaks the polygon contract) the picture is only about right.
///
/// @return three corners a triangle, counter-clockwise, at most two triangles a vertex
POLYGONAL_PERCEPTION_EXPORT std::vector<Eigen::Vector2d> triangulate(const PolygonSet& polygons);

}  // namespace polygonal_perception::geometry

#pragma once

#include <Eigen/Geometry>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/polygon_set.hpp"

namespace polygonal_perception::geometry {

/// The cross product a x b: positive where b points to the left of a. Rounded; `orientation` is exact.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/// @return [m^2] positive where the ring runs counter-clockwise; 0 without vertices
POLYGONAL_PERCEPTION_EXPORT double signedArea(const RingView& ring);

/// @return [m^2] of all polygons without their holes, which run clockwise and so count as negative
POLYGONAL_PERCEPTION_EXPORT double area(const PolygonSet& polygons);

/// @return the smallest box, along the axes, that holds all vertices; empty (isEmpty) without one
POLYGONAL_PERCEPTION_EXPORT Eigen::AlignedBox2d bounds(const RingView& ring);
POLYGONAL_PERCEPTION_EXPORT Eigen::AlignedBox2d bounds(const PolygonSet& polygons);

/// Moves polygons into another frame.
///
/// @param pose  of the polygons' frame in the other one; a rigid one keeps orientations and areas
POLYGONAL_PERCEPTION_EXPORT PolygonSet transformed(const PolygonSet& polygons, const Eigen::Isometry2d& pose);

}  // namespace polygonal_perception::geometry

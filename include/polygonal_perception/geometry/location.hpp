#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/polygon_set.hpp"

namespace polygonal_perception::geometry {

/// Where a point is.
enum class Location : std::uint8_t
{
  kOutside,
  kBoundary,  ///< on an edge or a vertex
  kInside
};

/// Where p is, decided without rounding (within the limits of predicates.hpp). The ring's orientation does
/// not matter; where it crosses itself, a point that it goes round an even number of times is outside.
POLYGONAL_PERCEPTION_EXPORT Location locate(const Eigen::Vector2d& p, const RingView& ring);

/// Where p is: in a hole is outside of the polygon, on the hole's edge is on the boundary. Polygons do not
/// overlap; where they do, a point that an even number of rings contain is outside.
POLYGONAL_PERCEPTION_EXPORT Location locate(const Eigen::Vector2d& p, const PolygonSet& polygons);

}  // namespace polygonal_perception::geometry

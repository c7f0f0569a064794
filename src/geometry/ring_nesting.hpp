#pragma once

#include <optional>

#include "polygonal_perception/geometry/validity.hpp"

namespace polygonal_perception::geometry {

/// Looks for rings that lie where they must not: kHoleOutside or kPolygonsOverlap.
/// @pre the rings do not meet, so that one vertex says where a ring lies
std::optional<Invalidity> findWrongNesting(const PolygonSet& polygons);

}  // namespace polygonal_perception::geometry

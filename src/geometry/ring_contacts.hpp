#pragma once

#include <optional>

#include "polygonal_perception/geometry/validity.hpp"

namespace polygonal_perception::geometry {

/// Looks for edges that have a point in common: of one ring (kRingMeetsItself), else of two (kRingsMeet).
/// @pre rings of at least 3 finite vertices, none repeated
std::optional<Invalidity> findContact(const PolygonSet& polygons);

}  // namespace polygonal_perception::geometry

#pragma once

#include <optional>

#include "geometry/ring_sweep.hpp"
#include "polygonal_perception/geometry/validity.hpp"

namespace polygonal_perception::geometry {

/// Looks for edges that have a point in common: of one ring (kRingMeetsItself), else of two (kRingsMeet).
/// @param sweep  over all rings of the set, not run yet; where nothing is found it knows which ring lies in which
std::optional<Invalidity> findContact(const PolygonSet& polygons, RingSweep& sweep);

}  // namespace polygonal_perception::geometry

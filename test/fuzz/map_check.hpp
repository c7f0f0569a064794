#pragma once

#include "polygonal_perception/mapping/polygon_map.hpp"
#include "support/map_lengths.hpp"

namespace polygonal_perception::test {

/// What holds of a map after each observation, whatever it showed: its grids fit one another, and its polygons are valid.
/// Ends the program when it does not.
void requireSound(const mapping::PolygonMap::Result& result);

/// By the exact checker, which takes longer: the first three clauses of the polygons' contract. The fourth one takes seconds
/// under a sanitizer; test_map_polygons has it.
void requireSafe(const mapping::PolygonMap::Result& result, const MapLengths& lengths);

}  // namespace polygonal_perception::test

#pragma once

#include "polygonal_perception/mapping/polygon_map.hpp"
#include "support/map_lengths.hpp"

namespace polygonal_perception::test {

/// What holds of a map after each observation, whatever it showed: its grids fit one another, and its polygons are valid.
/// Ends the program when it does not.
void requireSound(const mapping::PolygonMap::Result& result);

/// The first four clauses of the polygons' contract as well, which takes far longer.
void requireContract(const mapping::PolygonMap::Result& result, const MapLengths& lengths);

}  // namespace polygonal_perception::test

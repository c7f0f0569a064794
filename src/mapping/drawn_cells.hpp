#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "polygonal_perception/geometry/polygon_set.hpp"
#include "polygonal_perception/mapping/map_file.hpp"
#include "polygonal_perception/occupancy/grid/binary_grid.hpp"

namespace polygonal_perception::mapping {

/// The cells around polygons, on the lattice of a map.
struct DrawnCells
{
  occupancy::GridGeometry geometry;
  std::vector<std::uint8_t> cells;  ///< 1 where a polygon reaches into a cell, or touches it
};

/// The time grows with the cells around the polygons and those along their edges: of both what it takes is limited.
/// @param polygons    valid ones, within 1000 km
/// @param resolution  [m] of the lattice
std::variant<DrawnCells, MapFileError> drawCells(const geometry::PolygonSet& polygons, double resolution);

}  // namespace polygonal_perception::mapping

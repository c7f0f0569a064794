#pragma once

#include "polygonal_perception/mapping/polygon_map.hpp"
#include "reference/polygon_checker.hpp"

namespace polygonal_perception::test {

/// What a map's polygons are made with, in thousandths of a cell, so that they can be checked without rounding.
struct MapLengths
{
  int radius = 0;
  int tolerance = 0;

  reference::CellLength radiusInCells() const { return {radius, 1000}; }
  reference::CellLength limitInCells() const { return {radius + 1500 + tolerance, 1000}; }

  /// @param resolution  [m] of the map
  void setIn(mapping::PolygonMap::Parameters& parameters, double resolution) const
  {
    parameters.inflation.robot_radius = 1e-3 * radius * resolution;
    parameters.polygonizer.simplification_tolerance = 1e-3 * tolerance * resolution;
  }
};

}  // namespace polygonal_perception::test

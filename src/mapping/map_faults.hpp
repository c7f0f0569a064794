#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "polygonal_perception/mapping/map_file.hpp"

/// The parts of findFault. Each returns the first fault that it finds, or nothing.
namespace polygonal_perception::mapping {

/// Rings go by their index in the set: "ring 3 ...".
std::optional<std::string> findPolygonFault(const geometry::PolygonSet& polygons);

std::optional<std::string> findRadiusFault(double inflation_radius);

/// Of their numbers alone, without the layers: what says how large these are.
std::optional<std::string> findGridFault(int cells_x, int cells_y, double resolution, double origin_x,
                                         double origin_y);

std::optional<std::string> findCellsFault(const SavedCells& cells);

}  // namespace polygonal_perception::mapping

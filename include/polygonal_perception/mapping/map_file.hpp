#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/polygon_set.hpp"

namespace polygonal_perception::mapping {

/// A number for each cell of a map.
struct CellLayer
{
  std::string name;                  ///< UTF-8; each layer of a map has a name of its own
  std::vector<std::uint8_t> values;  ///< row-major, a row along x, the one with the least y first
};

/// The cells that a map goes on from. Cell (i, j) covers [i, i + 1) x [j, j + 1) times the resolution, from
/// (origin_x, origin_y).
struct SavedCells
{
  int cells_x = 0;          ///< at least 1
  int cells_y = 0;          ///< at least 1
  double resolution = 0.0;  ///< [m] side of a cell, more than 0
  double origin_x = 0.0;    ///< [m] in the map's frame
  double origin_y = 0.0;    ///< [m]
  std::vector<CellLayer> layers;
  double slab_height = 0.0;  ///< [m] of the heights that a layer may hold; 0: none does
};

/// What a map file holds.
struct MapFile
{
  std::string frame_id;           ///< UTF-8; empty where the file names none
  double inflation_radius = 0.0;  ///< [m] by which the polygons are larger than what stands there
  geometry::PolygonSet polygons;  ///< [m] in the map's frame
  std::optional<SavedCells> cells;
};

/// Why something was not written or not read.
struct MapFileError
{
  std::string text;  ///< ASCII but for paths, on one line
};

// A file of some bytes can ask for any amount of memory: what it may ask for is limited.
inline constexpr std::size_t kMostSavedCells = 100'000'000;  ///< of all layers together
inline constexpr std::size_t kMostSavedLayers = 1000;
inline constexpr std::size_t kMostSavedVertices = 1'000'000;

/// Checks what a file can hold: finite numbers, a radius that is not negative, polygons that are valid (see
/// geometry::findDefect) and whose coordinates the exact predicates take, cells within the limits above,
/// layers of the cells' size.
///
/// @return nothing where the map can be written and read back; else the first fault that was found
POLYGONAL_PERCEPTION_EXPORT std::optional<MapFileError> findFault(const MapFile& map);

}  // namespace polygonal_perception::mapping

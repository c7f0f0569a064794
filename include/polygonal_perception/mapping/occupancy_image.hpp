#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/mapping/map_file.hpp"

namespace polygonal_perception::mapping {

/// Writes an occupancy grid as map_server's map_saver does: an image PATH.pgm, the row with the largest y
/// first, and PATH.yaml with what it shows, from which map_server makes the same grid again.
///
/// It differs from map_saver's in two lines: the image is named without its folder, so that both can be moved,
/// and a number that six digits after the point do not hold has more of them.
///
/// Each file is written beside its place first, and takes it when both are complete. An error leaves the old
/// ones, unless the yaml alone cannot take its place.
///
/// @param path        without an extension
/// @param cells_x     at least 1; map_server's library for images takes no more than 16383
/// @param cells_y     at least 1; of these no more than 65535
/// @param resolution  [m] side of a cell
/// @param origin_x    [m] of the grid's corner with the least x and y, in the map's frame, which is not turned
/// @param origin_y    [m]
/// @param values      as of nav_msgs/OccupancyGrid, row-major, a row along x: 0 to 25 is free, 65 and more
///                    occupied, all others unknown
/// @return nothing when both are there, else the reason and the path
POLYGONAL_PERCEPTION_EXPORT std::optional<MapFileError> writeOccupancyImage(
    const std::string& path, int cells_x, int cells_y, double resolution, double origin_x, double origin_y,
    const std::vector<std::int8_t>& values);

}  // namespace polygonal_perception::mapping

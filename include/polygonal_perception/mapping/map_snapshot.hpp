#pragma once

#include <optional>
#include <string>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/mapping/map_file.hpp"
#include "polygonal_perception/mapping/polygon_map.hpp"

namespace polygonal_perception::mapping {

/// What a file needs so that the map goes on from it as it is now.
/// @param slab_height  [m] of the heights in the map
/// @pre map.map().isActive()
POLYGONAL_PERCEPTION_EXPORT MapFile takeSnapshot(PolygonMap& map, const std::string& frame_id,
                                                 double slab_height);

/// Puts a file in the place of the map. Of one with cells the map is the same as it was, as far as it fits in map_size; of
/// one that was drawn by hand, which has none, every cell that a polygon reaches into is occupied at all heights.
///
/// @param resolution  [m] of a map without cells
/// @param stamp       [s] when all of it counts as seen
/// @return nothing, or why not: polygons that have grown by a radius cannot be undone without cells
POLYGONAL_PERCEPTION_EXPORT std::optional<MapFileError> restoreSnapshot(const MapFile& file,
                                                                        double resolution, double stamp,
                                                                        PolygonMap& map);

}  // namespace polygonal_perception::mapping

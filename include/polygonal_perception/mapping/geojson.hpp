#pragma once

#include <optional>
#include <string>
#include <variant>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/mapping/map_file.hpp"

/// Map files: GeoJSON (RFC 7946), which QGIS, geojson.io and most libraries read, with members of our own.
///
///     {"type": "FeatureCollection",
///      "frame_id": "map",                           frame of tf that the coordinates are in
///      "units": "metres",                           of the coordinates: they are no degrees
///      "inflation_radius": 0.3,                     [m]
///      "features": [{"type": "Feature", "properties": {},
///                    "geometry": {"type": "Polygon", "coordinates": [[[0.0, 0.0], ...], ...]}}, ...],
///      "cells": {"cells_x": 200, "cells_y": 100, "resolution": 0.05, "origin_x": -5.0, "origin_y": -2.5,
///                "layers": [{"name": "free", "runs": [17, 0, 3, 255, ...]}, ...]}}
///
/// A polygon's boundary comes first and runs counter-clockwise, its holes run clockwise, and each ring repeats
/// its first position at its end. `runs` has the values of a layer: a count and a value, a count and a value.
///
/// Nothing is thrown but std::bad_alloc.
namespace polygonal_perception::mapping {

/// @return the text of a file, from which readGeoJson makes the same map again, bit for bit; or what is wrong
///         with the map (see findFault)
POLYGONAL_PERCEPTION_EXPORT std::variant<std::string, MapFileError> writeGeoJson(const MapFile& map);

/// Reads what writeGeoJson wrote, and what others draw. A MultiPolygon is taken apart, a ring that runs the
/// wrong way is turned round, a third coordinate is left out, and so are members that are not named above.
/// Without "frame_id", "inflation_radius" or "cells" it is that of an empty MapFile.
///
/// Everything else is refused: what is no FeatureCollection of polygons in metres, what findFault finds.
///
/// @param text  of any length and content, from anybody
/// @return the map, or the reason why it is refused, with the feature, the ring (both from 0) and the place
POLYGONAL_PERCEPTION_EXPORT std::variant<MapFile, MapFileError> readGeoJson(const std::string& text);

/// The same to a file. It is written whole or not at all: beside its place first.
///
/// @return nothing when it is there, else the reason and the path
POLYGONAL_PERCEPTION_EXPORT std::optional<MapFileError> writeGeoJsonFile(const std::string& path,
                                                                         const MapFile& map);

/// The same from a file of at most 1 GB.
///
/// @return the map, or the path and the reason
POLYGONAL_PERCEPTION_EXPORT std::variant<MapFile, MapFileError> readGeoJsonFile(const std::string& path);

}  // namespace polygonal_perception::mapping

#pragma once

#include <string>
#include <variant>

#include "mapping/json_document.hpp"
#include "polygonal_perception/mapping/map_file.hpp"

namespace polygonal_perception::mapping {

/// readGeoJson with other limits.
std::variant<MapFile, MapFileError> readLimited(const std::string& text, const JsonLimits& limits);

}  // namespace polygonal_perception::mapping

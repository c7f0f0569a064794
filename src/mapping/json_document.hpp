#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

#include "polygonal_perception/mapping/map_file.hpp"

namespace polygonal_perception::mapping {

using Json = nlohmann::json;

/// What a text may ask for. The defaults are enough for each map that findFault accepts.
struct JsonLimits
{
  std::size_t depth = 32;               ///< of arrays and objects in one another
  std::size_t values = 8'000'000;       ///< without those of runs; each takes up to 100 bytes
  std::size_t cells = kMostSavedCells;  ///< of all layers together
};

/// A parsed text.
// NOLINTNEXTLINE(bugprone-exception-escape): what moving nlohmann::json calls is not declared noexcept
struct JsonDocument
{
  Json root;
  /// The values of each layer, made while cells/layers/[k]/runs is read, which can have far more numbers than
  /// all the rest. In `root` there is an empty array in its place.
  std::vector<std::vector<std::uint8_t>> layers;
};

/// @return the document, or why there is none, with line and column and the feature where it is in one
std::variant<JsonDocument, MapFileError> parseJson(const std::string& text, const JsonLimits& limits);

/// @return the member of that name; nullptr where `json` has none or is no object
const Json* findMember(const Json& json, const char* name);

/// A value as an error text shows it: ASCII, cut where it is long, an array or object by its kind.
std::string shown(const Json& json);

/// A text that is cut where it is long.
std::string cut(const std::string& text);

}  // namespace polygonal_perception::mapping

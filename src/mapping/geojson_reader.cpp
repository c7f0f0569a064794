#include "mapping/geojson_reader.hpp"

#include <cstdint>
#include <utility>
#include <vector>

#include "mapping/feature_reader.hpp"
#include "mapping/map_faults.hpp"
#include "mapping/whole_file.hpp"
#include "polygonal_perception/mapping/geojson.hpp"

namespace polygonal_perception::mapping {

namespace {

/// What is wrong, or nothing.
using Fault = std::optional<std::string>;

std::string wrongMember(const char* name, const Json* member, const std::string& accepted)
{
  return std::string(name) + " is " + (member == nullptr ? "missing" : shown(*member)) + ", accepted is " +
         accepted;
}

Fault readNumber(const Json& object, const char* name, double& value)
{
  const Json* const member = findMember(object, name);
  if (member == nullptr || !member->is_number()) return wrongMember(name, member, "a number");
  value = member->get<double>();
  return std::nullopt;
}

Fault readCount(const Json& object, const char* name, int& value)
{
  const Json* const member = findMember(object, name);
  if (member == nullptr || !member->is_number_unsigned() || member->get<std::uint64_t>() > kMostSavedCells)
    return wrongMember(name, member, "a whole number from 1 to " + std::to_string(kMostSavedCells));
  value = member->get<int>();
  return std::nullopt;
}

/// @param values  of all layers; those of this one are taken
Fault readLayer(const Json& json, std::vector<std::uint8_t>& values, CellLayer& layer)
{
  const Json* const name = findMember(json, "name");
  if (name == nullptr || !name->is_string()) return wrongMember("name", name, "a text");
  const Json* const runs = findMember(json, "runs");
  if (runs == nullptr || !runs->is_array()) return wrongMember("runs", runs, "an array");
  layer.name = name->get<std::string>();
  layer.values = std::move(values);
  return std::nullopt;
}

/// @param layers  the values of each
Fault readCells(const Json& json, std::vector<std::vector<std::uint8_t>>& layers, SavedCells& cells)
{
  if (auto fault = readCount(json, "cells_x", cells.cells_x)) return fault;
  if (auto fault = readCount(json, "cells_y", cells.cells_y)) return fault;
  if (auto fault = readNumber(json, "resolution", cells.resolution)) return fault;
  if (auto fault = readNumber(json, "origin_x", cells.origin_x)) return fault;
  if (auto fault = readNumber(json, "origin_y", cells.origin_y)) return fault;
  if (findMember(json, "slab_height") != nullptr) {
    if (auto fault = readNumber(json, "slab_height", cells.slab_height)) return fault;
  }
  const Json* const members = findMember(json, "layers");
  if (members == nullptr || !members->is_array()) return wrongMember("layers", members, "an array");
  if (members->size() > kMostSavedLayers)
    return "there are more than " + std::to_string(kMostSavedLayers) + " layers";
  layers.resize(members->size());
  cells.layers.resize(members->size());
  for (std::size_t k = 0; k < layers.size(); ++k) {
    if (auto fault = readLayer((*members)[k], layers[k], cells.layers[k]))
      return "layer " + std::to_string(k) + ": " + *fault;
  }
  return std::nullopt;
}

/// All but the features.
Fault readMembers(JsonDocument& document, MapFile& map)
{
  const Json& root = document.root;
  if (const Json* const units = findMember(root, "units"); units != nullptr && *units != "metres")
    return wrongMember("units", units, "\"metres\"");
  if (const Json* const frame_id = findMember(root, "frame_id"); frame_id != nullptr) {
    if (!frame_id->is_string()) return wrongMember("frame_id", frame_id, "a text");
    map.frame_id = frame_id->get<std::string>();
  }
  if (findMember(root, "inflation_radius") != nullptr) {
    if (auto fault = readNumber(root, "inflation_radius", map.inflation_radius)) return fault;
    if (auto fault = findRadiusFault(map.inflation_radius)) return fault;
  }
  if (const Json* const cells = findMember(root, "cells"); cells != nullptr) {
    if (auto fault = readCells(*cells, document.layers, map.cells.emplace())) return "cells: " + *fault;
    return findCellsFault(*map.cells);
  }
  return std::nullopt;
}

Fault readFeatures(const Json& root, geometry::PolygonSet& polygons)
{
  const Json* const type = findMember(root, "type");
  if (type == nullptr || *type != "FeatureCollection")
    return wrongMember("type", type, "\"FeatureCollection\"");
  const Json* const features = findMember(root, "features");
  if (features == nullptr || !features->is_array()) return wrongMember("features", features, "an array");
  FeatureReader reader;
  if (auto fault = reader.read(*features)) return fault;
  if (auto fault = findPolygonFault(reader.polygons())) return withPlaces(*fault, reader.places());
  polygons = std::move(reader.polygons());
  return std::nullopt;
}

}  // namespace

std::variant<MapFile, MapFileError> readLimited(const std::string& text, const JsonLimits& limits)
{
  auto parsed = parseJson(text, limits);
  auto* const document = std::get_if<JsonDocument>(&parsed);
  if (document == nullptr) return std::get<MapFileError>(std::move(parsed));
  MapFile map;
  if (auto fault = readFeatures(document->root, map.polygons)) return MapFileError{*fault};
  if (auto fault = readMembers(*document, map)) return MapFileError{*fault};
  return map;
}

std::variant<MapFile, MapFileError> readGeoJson(const std::string& text)
{
  return readLimited(text, {});
}

std::variant<MapFile, MapFileError> readGeoJsonFile(const std::string& path)
{
  constexpr std::size_t kMostBytes = 1'000'000'000;
  auto text = readWhole(path, kMostBytes);
  if (auto* const error = std::get_if<MapFileError>(&text)) return std::move(*error);
  auto map = readGeoJson(std::get<std::string>(text));
  if (auto* const error = std::get_if<MapFileError>(&map)) return readFailure(path, error->text);
  return map;
}

}  // namespace polygonal_perception::mapping

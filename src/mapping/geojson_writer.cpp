#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>

#include "mapping/number_text.hpp"
#include "mapping/run_lengths.hpp"
#include "mapping/whole_file.hpp"
#include "polygonal_perception/mapping/geojson.hpp"

namespace polygonal_perception::mapping {

namespace {

/// Writes by hand: a feature and a layer a line, and no tree of a million numbers.
class GeoJsonText
{
public:
  explicit GeoJsonText(const MapFile& map)
  {
    text_ += "{\"type\": \"FeatureCollection\",\n\"frame_id\": " + quoted(map.frame_id) +
             ",\n\"units\": \"metres\",\n\"inflation_radius\": " + shortText(map.inflation_radius) +
             ",\n\"features\": [";
    add(map.polygons);
    text_ += "]";
    if (map.cells) add(*map.cells);
    text_ += "}\n";
  }

  std::string& text() { return text_; }

private:
  static std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

  void add(const geometry::PolygonSet& polygons)
  {
    const char* before_first = "\n";
    for (std::size_t r = 0; r < polygons.rings.size(); ++r) {
      if (polygons.rings[r].hole) {
        text_ += ", ";
      } else {
        text_ += r == 0 ? before_first : "]}},\n";
        text_ +=
            "{\"type\": \"Feature\", \"properties\": {}, \"geometry\": {\"type\": \"Polygon\", "
            "\"coordinates\": [";
      }
      add(polygons.view(polygons.rings[r]));
    }
    if (!polygons.rings.empty()) text_ += "]}}\n";
  }

  void add(const geometry::RingView& ring)
  {
    text_ += "[";
    for (const Eigen::Vector2d& vertex : ring) {
      add(vertex);
      text_ += ", ";
    }
    add(ring[0]);
    text_ += "]";
  }

  void add(const Eigen::Vector2d& position)
  {
    text_ += "[" + shortText(position.x()) + ", " + shortText(position.y()) + "]";
  }

  void add(const SavedCells& cells)
  {
    text_ += ",\n\"cells\": {\"cells_x\": " + std::to_string(cells.cells_x) +
             ", \"cells_y\": " + std::to_string(cells.cells_y) +
             ", \"resolution\": " + shortText(cells.resolution) +
             ", \"origin_x\": " + shortText(cells.origin_x) + ", \"origin_y\": " + shortText(cells.origin_y) +
             (cells.slab_height > 0.0 ? ", \"slab_height\": " + shortText(cells.slab_height) : "") +
             ", \"layers\": [";
    const char* before = "\n";
    for (const CellLayer& layer : cells.layers) {
      text_ += before;
      add(layer);
      before = ",\n";
    }
    text_ += "]}";
  }

  void add(const CellLayer& layer)
  {
    text_ += "{\"name\": " + quoted(layer.name) + ", \"runs\": [";
    const char* before = "";
    forEachRun(layer.values, [&](std::size_t count, std::uint8_t value) {
      text_ += before + std::to_string(count) + "," + std::to_string(value);
      before = ",";
    });
    text_ += "]}";
  }

  std::string text_;
};

}  // namespace

std::variant<std::string, MapFileError> writeGeoJson(const MapFile& map)
{
  if (auto fault = findFault(map)) return std::move(*fault);
  return std::move(GeoJsonText(map).text());
}

std::optional<MapFileError> writeGeoJsonFile(const std::string& path, const MapFile& map)
{
  const auto text = writeGeoJson(map);
  if (const auto* const error = std::get_if<MapFileError>(&text)) return writeFailure(path, error->text);
  return writeWhole(path, std::get<std::string>(text));
}

}  // namespace polygonal_perception::mapping

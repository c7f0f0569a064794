#include "polygonal_perception/mapping/map_snapshot.hpp"

#include <algorithm>
#include <cmath>

#include "mapping/drawn_cells.hpp"

namespace polygonal_perception::mapping {

namespace {

constexpr char kHeights[] = "heights";
constexpr char kSeen[] = "seen";

const std::vector<std::uint8_t>* findLayer(const SavedCells& cells, const char* name)
{
  for (const CellLayer& layer : cells.layers) {
    if (layer.name == name) return &layer.values;
  }
  return nullptr;
}

}  // namespace

MapFile takeSnapshot(PolygonMap& map, const std::string& frame_id, double slab_height)
{
  PolygonMap::Products products;
  products.polygons = true;
  MapFile file;
  file.frame_id = frame_id;
  file.inflation_radius = map.parameters().inflation.robot_radius;
  file.polygons = map.make(products).polygons;
  const occupancy::GridGeometry geometry = map.map().geometry();
  SavedCells& cells = file.cells.emplace();
  cells.cells_x = geometry.cells_x;
  cells.cells_y = geometry.cells_y;
  cells.resolution = geometry.resolution;
  cells.origin_x = geometry.origin_x;
  cells.origin_y = geometry.origin_y;
  cells.slab_height = slab_height;
  cells.layers.resize(2);
  cells.layers[0].name = kHeights;
  map.map().copyHeights(cells.layers[0].values);
  cells.layers[1].name = kSeen;
  map.map().copySeen(cells.layers[1].values);
  return file;
}

std::optional<MapFileError> restoreSnapshot(const MapFile& file, double resolution, double stamp,
                                            PolygonMap& map)
{
  // What the cells of an observation may be, too: beyond that they have no numbers.
  constexpr double kSmallest = 0.001;  // [m]
  constexpr double kLargest = 10.0;    // [m]
  constexpr double kFarthest = 1e6;    // [m]
  const auto isFar = [](double x, double y) { return std::abs(x) > kFarthest || std::abs(y) > kFarthest; };
  if (file.cells && !(file.cells->resolution >= kSmallest && file.cells->resolution <= kLargest))
    return MapFileError{"cells: the resolution is not within 0.001 to 10 m"};
  bool is_far = file.cells && isFar(file.cells->origin_x, file.cells->origin_y);
  for (const Eigen::Vector2d& vertex : file.polygons.vertices)
    is_far = is_far || isFar(vertex.x(), vertex.y());
  if (is_far) return MapFileError{"something lies farther than 1000 km from the origin"};
  if (file.cells) {
    const std::vector<std::uint8_t>* const heights = findLayer(*file.cells, kHeights);
    const std::vector<std::uint8_t>* const seen = findLayer(*file.cells, kSeen);
    if (heights == nullptr || seen == nullptr)
      return MapFileError{"cells have no layer 'heights' or none 'seen': this is no map of polygon_map"};
    occupancy::GridGeometry geometry;
    geometry.cells_x = file.cells->cells_x;
    geometry.cells_y = file.cells->cells_y;
    geometry.resolution = file.cells->resolution;
    geometry.origin_x = file.cells->origin_x;
    geometry.origin_y = file.cells->origin_y;
    map.map().restore(geometry, *heights, *seen, stamp);
    return std::nullopt;
  }
  if (file.inflation_radius > 0.0) {
    return MapFileError{
        "inflation_radius is above 0 and there are no cells: what stands in polygons that have grown cannot "
        "be told, "
        "accepted are polygons as things stand, without inflation_radius"};
  }
  const auto drawing = drawCells(file.polygons, resolution);
  if (const auto* const error = std::get_if<MapFileError>(&drawing)) return *error;
  const auto& drawn = std::get<DrawnCells>(drawing);
  std::vector<std::uint8_t> heights(drawn.cells.size());
  constexpr std::uint8_t kAll = 0xFF;
  std::transform(drawn.cells.begin(), drawn.cells.end(), heights.begin(),
                 [](std::uint8_t cell) { return cell != 0 ? kAll : std::uint8_t{0}; });
  map.map().restore(drawn.geometry, heights, std::vector<std::uint8_t>(heights.size(), 0), stamp);
  return std::nullopt;
}

}  // namespace polygonal_perception::mapping

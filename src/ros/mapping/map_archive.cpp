#include "ros/mapping/map_archive.hpp"

#include "polygonal_perception/mapping/geojson.hpp"
#include "polygonal_perception/mapping/map_snapshot.hpp"
#include "polygonal_perception/mapping/occupancy_image.hpp"

namespace polygonal_perception::ros_mapping {

namespace {

bool endsWith(const std::string& text, const std::string& end)
{
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// -1 where nothing was seen, 100 where something stands, 0 where the floor was seen.
std::vector<std::int8_t> occupancyValues(const mapping::PolygonMap::Result& map)
{
  std::vector<std::int8_t> values(map.seen.size(), -1);
  for (std::size_t cell = 0; cell < values.size(); ++cell) {
    if (map.occupied.cells()[cell] != 0) {
      values[cell] = 100;
    } else if (map.seen[cell] != 0) {
      values[cell] = 0;
    }
  }
  return values;
}

std::string countText(const geometry::PolygonSet& polygons)
{
  std::size_t count = 0;
  for (const geometry::PolygonSet::Ring& ring : polygons.rings) count += ring.hole ? 0 : 1;
  return std::to_string(count) + " polygons";
}

}  // namespace

ros_common::Expected<std::string> saveMap(mapping::PolygonMap& map, const std::string& frame_id,
                                          double slab_height, const std::string& path)
{
  using Result = ros_common::Expected<std::string>;
  if (path.empty()) return Result::failure("path is empty, accepted is the name of a file");
  if (!map.map().isActive()) return Result::failure("the map is empty: no observation has come yet");
  const std::string file = endsWith(path, ".geojson") || endsWith(path, ".json") ? path : path + ".geojson";
  const std::string base = file.substr(0, file.rfind('.'));
  const mapping::MapFile snapshot = mapping::takeSnapshot(map, frame_id, slab_height);
  if (const auto error = mapping::writeGeoJsonFile(file, snapshot)) return Result::failure(error->text);
  mapping::PolygonMap::Products products;
  products.seen = true;
  const auto& result = map.make(products);
  const occupancy::GridGeometry geometry = map.map().geometry();
  if (const auto error =
          mapping::writeOccupancyImage(base, geometry.cells_x, geometry.cells_y, geometry.resolution,
                                       geometry.origin_x, geometry.origin_y, occupancyValues(result)))
    return Result::failure(error->text);
  return countText(snapshot.polygons) + " in " + file + ", and " + base + ".pgm and .yaml";
}

ros_common::Expected<LoadedMap> loadMap(mapping::PolygonMap& map, const std::string& frame_id,
                                        double resolution, const ros::Time& stamp, const std::string& path)
{
  using Result = ros_common::Expected<LoadedMap>;
  const auto read = mapping::readGeoJsonFile(path);
  if (const auto* const error = std::get_if<mapping::MapFileError>(&read))
    return Result::failure(error->text);
  const auto& file = std::get<mapping::MapFile>(read);
  if (!file.frame_id.empty() && file.frame_id != frame_id) {
    return Result::failure("the frame_id of " + path + " is '" + file.frame_id +
                           "', accepted is fixed_frame, '" + frame_id + "'");
  }
  if (const auto error = mapping::restoreSnapshot(file, resolution, stamp.toSec(), map))
    return Result::failure(path + ": " + error->text);
  return LoadedMap{countText(file.polygons) + " from " + path, file.cells ? file.cells->slab_height : 0.0};
}

}  // namespace polygonal_perception::ros_mapping

// Scenes that are not made up: of a simulated drive, and public ones.
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "paths/path_scenes.hpp"
#include "polygonal_perception/mapping/polygon_map.hpp"
#include "reference/observed_drive.hpp"

namespace polygonal_perception::evaluation {

namespace {

using nlohmann::json;
using Ring = std::vector<Eigen::Vector2d>;

json read(const std::string& path)
{
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + " cannot be read");
  try {
    return json::parse(file);
  } catch (const json::exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

/// The two numbers of a list from a place on.
Eigen::Vector2d pointOf(const json& list, std::size_t first = 0)
{
  return {list.at(first).get<double>(), list.at(first + 1).get<double>()};
}

Ring ringOf(const json& points)
{
  Ring ring;
  for (const json& point : points) ring.push_back(pointOf(point));
  return ring;
}

PathScene arenaScene(const std::string& path)
{
  PathScene scene{"arena", {}, {}};
  const json arena = read(path);
  for (const json& polygon : arena.at("polygons")) {
    scene.obstacles.append(ringOf(polygon.at("boundary")), false);
    for (const json& hole : polygon.at("holes")) scene.obstacles.append(ringOf(hole), true);
  }
  for (const json& query : arena.at("queries"))
    scene.queries.push_back({pointOf(query), pointOf(query, 2), query.at(4).get<double>()});
  return scene;
}

PathScene barnScene(const json& world)
{
  constexpr double kRobot = 0.25;  // [m] radius
  constexpr int kSides = 16;
  PathScene scene{"BARN", {}, {}};
  for (const json& cylinder : world.at("cylinders")) {
    const Eigen::Vector2d middle = pointOf(cylinder);
    const double reach = (cylinder.at(2).get<double>() + kRobot) / std::cos(M_PI / kSides);
    Ring ring;
    for (int k = 0; k < kSides; ++k) {
      const double angle = 2.0 * M_PI * (k + 0.5) / kSides;
      ring.push_back(middle + reach * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    scene.obstacles.append(ring, false);
  }
  scene.queries.push_back({pointOf(world.at("start")), pointOf(world.at("goal")), std::nullopt});
  return scene;
}

geometry::PolygonSet polygonsOf(mapping::PolygonMap& map, const reference::ObservedFrame& frame, double stamp)
{
  map.update({frame.geometry, frame.pose, frame.cells.hit.data(), frame.cells.free.data(),
              frame.cells.floor.data(), true, stamp},
             frame.robot);
  mapping::PolygonMap::Products products;
  products.polygons = true;
  return map.make(products).polygons;
}

}  // namespace

std::vector<PathScene> drivenScenes()
{
  constexpr std::size_t kEvery = 6;  // frames
  std::vector<PathScene> scenes;
  auto frames = drivenPolygons(false);
  for (std::size_t i = 0; i < frames.size(); i += kEvery)
    if (!frames[i].rings.empty()) scenes.push_back({"our frames", std::move(frames[i]), {}});
  scenes.push_back({"our maps", drivenPolygons(true).back(), {}});
  return scenes;
}

std::vector<geometry::PolygonSet> drivenPolygons(bool remembers)
{
  std::vector<geometry::PolygonSet> polygons;
  mapping::PolygonMap map{mapping::PolygonMap::Parameters{}};
  double stamp = 0.0;
  for (const reference::ObservedFrame& frame : reference::observedDrive()) {
    stamp += 1.0 / 3.0;
    if (!remembers) map = mapping::PolygonMap{mapping::PolygonMap::Parameters{}};
    polygons.push_back(polygonsOf(map, frame, stamp));
  }
  return polygons;
}

std::vector<PathScene> publicScenes(const std::string& folder)
{
  std::vector<PathScene> scenes{arenaScene(folder + "/arena.json")};
  for (const json& world : read(folder + "/barn.json")) scenes.push_back(barnScene(world));
  return scenes;
}

}  // namespace polygonal_perception::evaluation

#include "polygonal_perception/cameras/simulation/scene.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "cameras/simulation/scene_layouts.hpp"
#include "polygonal_perception/cameras/simulation/random.hpp"

namespace polygonal_perception::simulation {
namespace {

struct Layout
{
  const char* name;
  void (*lay_out)(Scene&, Random&);
  bool is_course = false;
};

constexpr std::array<Layout, 16> kLayouts{{{"corridor", layOutCorridor},
                                           {"office", layOutOffice},
                                           {"busy_office", layOutBusyOffice},
                                           {"person", layOutPerson},
                                           {"table_top", layOutTableTop},
                                           {"wall", layOutWall},
                                           {"doorway", layOutDoorway},
                                           {"stairs", layOutStairs},
                                           {"ledge", layOutLedge},
                                           {"dais", layOutDais},
                                           {"pallet", layOutPallet},
                                           {"kerb", layOutKerb},
                                           {"threshold", layOutThreshold},
                                           {"ramp", layOutRamp},
                                           {"carpet", layOutCarpet},
                                           {"ramps", layOutRamps, true}}};

std::vector<std::string> namesOf(bool courses)
{
  std::vector<std::string> names;
  for (const Layout& layout : kLayouts) {
    if (layout.is_course == courses) names.emplace_back(layout.name);
  }
  return names;
}

}  // namespace

void Scene::walkersAt(double time, std::vector<Solid>& people) const
{
  people.clear();
  for (const Walker& walker : walkers) addPerson(people, walker.at(time));
}

double Scene::groundHeight(const Eigen::Vector2d& place) const
{
  for (const Ground& ground : grounds) {
    if (distanceTo(ground.outline, place) > 0.0) continue;
    const geometry::Plane& plane = ground.plane;
    return -(plane.normal.head<2>().dot(place) + plane.distance) / plane.normal.z();
  }
  return 0.0;
}

std::vector<Outline> Scene::obstacles(double time, double min_height, double max_height) const
{
  std::vector<Outline> outlines;
  const auto add = [&](const Solid& solid) {
    if (solid.surface != Surface::kObstacle) return;
    Outline outline = footprint(solid, min_height, max_height);
    if (outline.size() >= 3) outlines.push_back(std::move(outline));
  };
  for (const Solid& solid : solids) add(solid);
  std::vector<Solid> people;
  walkersAt(time, people);
  for (const Solid& solid : people) add(solid);
  return outlines;
}

const std::vector<std::string>& sceneNames()
{
  static const std::vector<std::string> names = namesOf(false);
  return names;
}

const std::vector<std::string>& courseNames()
{
  static const std::vector<std::string> names = namesOf(true);
  return names;
}

Scene makeScene(const std::string& name, std::uint64_t seed)
{
  for (std::size_t i = 0; i < kLayouts.size(); ++i) {
    if (name != kLayouts[i].name) continue;
    Scene scene;
    scene.name = name;
    Random random(seed, i);
    kLayouts[i].lay_out(scene, random);
    return scene;
  }
  std::string known;
  for (const Layout& layout : kLayouts) known += std::string(" ") + layout.name;
  throw std::invalid_argument("no scene is named '" + name + "'; there are:" + known);
}

}  // namespace polygonal_perception::simulation

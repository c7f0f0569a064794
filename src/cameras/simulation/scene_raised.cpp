// The scenes in which something level, or nearly so, lies higher than the robot's floor and fills more of the view.
#include <cmath>

#include "cameras/simulation/room.hpp"
#include "cameras/simulation/scene_layouts.hpp"
#include "polygonal_perception/geometry/angle.hpp"

namespace polygonal_perception::simulation {
namespace {

/// A hall whose robot stands at low x and looks along x at what is raised, which begins at x = 0.
Rectangle addHall(Scene& scene, Random& random)
{
  Rectangle hall{{-random.uniform(1.6, 2.6), -random.uniform(1.6, 3.0)},
                 {random.uniform(3.0, 6.0), random.uniform(1.6, 3.0)}};
  addFloor(scene, random, hall);
  const double height = random.uniform(2.5, 3.5);
  addCeiling(scene, hall, height);
  addWalls(scene, hall, height);
  return hall;
}

/// The strip before x = 0 from which a robot looks at what begins there.
void lookFromBefore(Scene& scene, const Rectangle& hall)
{
  constexpr double kNearest = 0.25;
  constexpr double kFarthest = 1.2;
  ViewArea area;
  area.half_size = {0.5 * (kFarthest - kNearest), 0.5 * hall.size().y() - 0.6};
  area.centre = {-0.5 * (kFarthest + kNearest), hall.centre().y()};
  area.yaw_spread = 0.5;
  area.min_camera_height = 0.2;
  scene.view_areas.push_back(area);
}

/// A few things on what is raised, so that it is not the only thing in view.
void addThingsOn(Scene& scene, Random& random, const Rectangle& top, double height)
{
  const int things = random.integer(0, 3);
  for (int i = 0; i < things; ++i) {
    const Assembly at =
        Assembly(scene.solids)
            .at(random.uniform(0.4, 0.9) * top.high.x(), random.uniform(top.low.y(), top.high.y()) * 0.8,
                random.uniform(-3.0, 3.0), height);
    if (random.chance(0.5)) {
      addChair(at, random);
    } else {
      addBoxes(at, random);
    }
  }
}

}  // namespace

void layOutDais(Scene& scene, Random& random)
{
  const Rectangle hall = addHall(scene, random);
  const double height = random.uniform(0.08, 0.28);
  Rectangle dais{{0.0, hall.low.y()}, {random.uniform(1.5, hall.high.x()), hall.high.y()}};
  if (random.chance(0.5)) dais.low.y() += random.uniform(0.3, 1.2);
  if (random.chance(0.5)) dais.high.y() -= random.uniform(0.3, 1.2);
  Assembly(scene.solids)
      .reflecting(random.uniform(0.3, 0.7))
      .box({dais.low.x(), dais.low.y(), 0.0}, {dais.high.x(), dais.high.y(), height});
  addThingsOn(scene, random, dais, height);
  lookFromBefore(scene, hall);
}

void layOutPallet(Scene& scene, Random& random)
{
  const Rectangle hall = addHall(scene, random);
  // EUR pallets: 1.2 by 0.8 m, 144 mm high, five boards on top.
  constexpr double kLength = 1.2;
  constexpr double kWidth = 0.8;
  constexpr double kHeight = 0.144;
  constexpr double kBoard = 0.022;
  const int across = random.integer(1, 3);
  const int deep = random.integer(1, 2);
  for (int i = 0; i < across; ++i) {
    for (int j = 0; j < deep; ++j) {
      const double y = hall.centre().y() + (i - 0.5 * (across - 1)) * (kLength + 0.03);
      const Assembly at =
          Assembly(scene.solids)
              .reflecting(0.5)
              .at(0.5 * kWidth + j * (kWidth + 0.03), y, random.uniform(-2.0, 2.0) * geometry::kDegree);
      constexpr int kBoards = 5;
      constexpr double kBoardWidth = 0.13;
      for (int board = 0; board < kBoards; ++board) {
        const double x = -0.5 * kWidth + (kWidth - kBoardWidth) * board / (kBoards - 1.0);
        at.box({x, -0.5 * kLength, kHeight - kBoard}, {x + kBoardWidth, 0.5 * kLength, kHeight});
      }
      for (const double block : {-0.5 * kLength, -0.07, 0.5 * kLength - 0.145}) {
        at.box({-0.5 * kWidth, block, 0.0}, {0.5 * kWidth, block + 0.145, kHeight - kBoard});
      }
    }
  }
  lookFromBefore(scene, hall);
}

void layOutKerb(Scene& scene, Random& random)
{
  // A street and its pavement, which the robot may look along or across.
  const Rectangle street{{-3.0, -6.0}, {8.0, 6.0}};
  addFloor(scene, random, street);
  const double height = random.uniform(0.08, 0.16);
  const double width = random.uniform(1.5, 3.0);
  Assembly(scene.solids).reflecting(0.5).box({0.0, -6.0, 0.0}, {width, 6.0, height});
  addWall(Assembly(scene.solids), {width, -6.0}, {width, 6.0}, 4.0);
  const int posts = random.integer(0, 3);
  for (int post = 0; post < posts; ++post) {
    const double y = random.uniform(-2.0, 2.0);
    Assembly(scene.solids).cylinder({0.4, y, height}, {0.4, y, height + 1.0}, 0.05);
  }
  lookFromBefore(scene, {{-3.0, -3.0}, {8.0, 3.0}});
  scene.view_areas.back().yaw_spread = 0.9;
}

void layOutThreshold(Scene& scene, Random& random)
{
  // A door through which a sill is seen, or a room whose floor lies a little higher.
  const Rectangle hall = addHall(scene, random);
  const double height = random.uniform(0.03, 0.07);
  const double depth = random.chance(0.5) ? random.uniform(0.25, 0.6) : hall.high.x();
  const double door = random.uniform(0.8, 1.6);
  const double y = hall.centre().y() + random.uniform(-0.3, 0.3);
  const double top = random.uniform(2.0, 2.3);
  Assembly(scene.solids).reflecting(0.6).box({0.0, hall.low.y(), 0.0}, {depth, hall.high.y(), height});
  const double from_start = hall.high.y() - (y + 0.5 * door);
  addWall(Assembly(scene.solids), {0.05, hall.high.y()}, {0.05, hall.low.y()}, 2.5,
          {{from_start, from_start + door, 0.0, top}});
  ViewArea area;
  area.centre = {-0.6, y};
  area.half_size = {0.3, 0.3};
  area.yaw_spread = 0.35;
  area.min_camera_height = 0.2;
  scene.view_areas.push_back(area);
}

void layOutRamp(Scene& scene, Random& random)
{
  // A board that leads up, onto a dais or onto nothing.
  const Rectangle hall = addHall(scene, random);
  const double height = random.uniform(0.08, 0.28);
  const double length = random.uniform(0.8, 2.2);
  const double half_width = random.uniform(0.4, 1.2);
  const double y = hall.centre().y() + random.uniform(-0.5, 0.5);
  constexpr double kBoard = 0.02;
  Assembly(scene.solids)
      .reflecting(0.55)
      .at(0.0, y)
      .turned(-std::asin(height / length), Eigen::Vector3d::UnitY())
      .box({0.0, -half_width, -kBoard}, {length, half_width, 0.0});
  if (random.chance(0.6)) {
    const double begin = std::sqrt(length * length - height * height);
    const Rectangle dais{{begin, hall.low.y()}, hall.high};
    Assembly(scene.solids)
        .reflecting(0.5)
        .box({dais.low.x(), dais.low.y(), 0.0}, {dais.high.x(), dais.high.y(), height});
  }
  lookFromBefore(scene, hall);
}

void layOutCarpet(Scene& scene, Random& random)
{
  // Thick carpets, foam mats and plates that cover most of the floor.
  const Rectangle hall = addHall(scene, random);
  const double height = random.uniform(0.03, 0.05);
  Assembly(scene.solids)
      .reflecting(random.uniform(0.3, 0.6))
      .box({0.0, hall.low.y() + random.uniform(0.0, 0.8), 0.0},
           {hall.high.x() - random.uniform(0.0, 1.0), hall.high.y() - random.uniform(0.0, 0.8), height});
  addThingsOn(scene, random, {{0.0, hall.low.y()}, hall.high}, height);
  lookFromBefore(scene, hall);
}

}  // namespace polygonal_perception::simulation

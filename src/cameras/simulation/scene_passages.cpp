// The scenes that a robot drives through.
#include <cmath>

#include "cameras/simulation/room.hpp"
#include "cameras/simulation/scene_layouts.hpp"
#include "polygonal_perception/geometry/angle.hpp"

namespace polygonal_perception::simulation {
namespace {

constexpr double kSideRoom = 3.0;  // [m] how deep the rooms beside a corridor are

/// Doors along a wall of a corridor: their openings, and what closes them or lies behind them.
std::vector<Opening> addDoors(const Assembly& wall, Random& random, double length)
{
  std::vector<Opening> doors;
  for (double start = random.uniform(0.5, 2.5); start + 1.3 < length; start += random.uniform(2.0, 4.5)) {
    const double width = random.uniform(0.8, 1.1);
    const Opening door{start, start + width, 0.0, random.uniform(2.0, 2.15)};
    doors.push_back(door);
    if (random.chance(0.7)) {
      const double recess = random.uniform(-0.12, -0.03);
      wall.reflecting(random.uniform(0.3, 0.8))
          .box({door.start, recess - 0.04, 0.005}, {door.end, recess, door.top});
      wall.reflecting(0.6).box({door.end - 0.12, recess, 1.0}, {door.end - 0.05, recess + 0.05, 1.03});
    } else {
      // An open door leads into a room of its own; the leaf stands against that room's side.
      const double left = door.start - random.uniform(0.1, 0.4);
      const double right = door.end + random.uniform(0.1, 0.5);
      for (const double side : {left, right}) {
        wall.box({side - 0.05, -kSideRoom, 0.0}, {side + 0.05, -0.15, 2.4});
      }
      wall.box({left, -kSideRoom - 0.1, 0.0}, {right, -kSideRoom, 2.4});
      if (random.chance(0.5)) addBoxes(wall.at(0.5 * (left + right), -0.6 * kSideRoom), random);
    }
  }
  return doors;
}

}  // namespace

void layOutCorridor(Scene& scene, Random& random)
{
  const double length = random.uniform(8.0, 22.0);
  const double width = random.uniform(1.7, 2.8);
  const double height = random.uniform(2.4, 2.9);
  const Rectangle corridor{{0.0, -0.5 * width}, {length, 0.5 * width}};
  const Rectangle whole{{-0.2, -0.5 * width - kSideRoom}, {length + 0.2, 0.5 * width + kSideRoom}};
  addFloor(scene, random, whole);
  scene.floor = {corridor.outline()};
  addCeiling(scene, whole, height);
  const Outline corners = corridor.outline();
  const Assembly world(scene.solids);
  RoomWalls walls;
  walls.openings[0] = addDoors(world.at(corners[0].x(), corners[0].y()), random, length);
  walls.openings[2] = addDoors(world.at(corners[2].x(), corners[2].y(), geometry::kPi), random, length);
  walls.openings[1] = maybeWindow(random, width);
  addWalls(scene, corridor, height, walls);

  // What stands in a corridor stands at its sides and leaves the way free.
  for (double x = random.uniform(1.5, 3.0); x + 1.5 < length; x += random.uniform(1.0, 3.5)) {
    const double side = random.sign();
    const Assembly at =
        world.at(x, side * (0.5 * width - 0.25), side > 0 ? -geometry::kPi / 2 : geometry::kPi / 2);
    switch (random.integer(0, 5)) {
      case 0:
        at.reflecting(0.6).box({-0.2, -0.45, 0.0}, {0.15, 0.45, random.uniform(0.7, 1.9)});
        break;
      case 1:
        addBoxes(at.at(0.0, 0.0), random);
        break;
      case 2:
        addBag(at, random);
        break;
      case 3:
        addSmallThing(at, random);
        break;
      case 4:
        addChair(at, random);
        break;
      default:
        addCable(at, random, random.uniform(0.5, 2.0));
    }
  }
  if (random.chance(0.3)) {
    PersonPose passer_by;
    passer_by.position = {random.uniform(3.0, length - 1.0), random.uniform(-0.3, 0.3) * width};
    passer_by.yaw = random.uniform(-geometry::kPi, geometry::kPi);
    passer_by.stride = random.uniform(0.0, 2.0 * geometry::kPi);
    passer_by.stride_amplitude = 0.4;
    addPerson(scene.solids, passer_by);
  }
  ViewArea along;
  along.centre = {0.35 * length, 0.0};
  along.half_size = {0.35 * length - 0.6, 0.5 * width - 0.45};
  along.yaw_spread = 0.5;
  scene.view_areas.push_back(along);
}

void layOutDoorway(Scene& scene, Random& random)
{
  const double near_depth = random.uniform(3.0, 5.0);
  const double far_depth = random.uniform(2.0, 5.0);
  const double half_width = random.uniform(1.5, 3.0);
  const double height = random.uniform(2.4, 2.8);
  const Rectangle whole{{-near_depth, -half_width}, {far_depth, half_width}};
  addFloor(scene, random, whole);
  addCeiling(scene, whole, height);
  const Assembly world(scene.solids);
  const Rectangle near_room{{-near_depth, -half_width}, {-0.15, half_width}};
  const Rectangle far_room{{0.0, -half_width}, {far_depth, half_width}};
  RoomWalls near_walls;
  near_walls.missing[1] = true;
  addWalls(scene, near_room, height, near_walls);
  RoomWalls far_walls;
  far_walls.missing[3] = true;
  far_walls.openings[1] = maybeWindow(random, 2.0 * half_width);
  addWalls(scene, far_room, height, far_walls);

  // The wall between them; its opening runs from door_low to door_low + door_width.
  const double door_width = random.uniform(0.8, 1.2);
  const double door_low = random.uniform(-0.6 * half_width, 0.6 * half_width - door_width);
  const double door_top = random.uniform(1.95, 2.2);
  addWall(world, {-0.15, -half_width}, {-0.15, half_width}, height,
          {{door_low + half_width, door_low + half_width + door_width, 0.0, door_top}});
  const Assembly frame = world.reflecting(0.7);
  for (const double y : {door_low, door_low + door_width}) {
    frame.box({-0.18, y - 0.04, 0.0}, {0.03, y + 0.04, door_top});
  }
  frame.box({-0.18, door_low - 0.04, door_top}, {0.03, door_low + door_width + 0.04, door_top + 0.06});
  if (random.chance(0.5))
    world.reflecting(0.5).box({-0.15, door_low, 0.0},
                              {0.0, door_low + door_width, random.uniform(0.003, 0.015)});
  if (random.chance(0.8)) {
    // The leaf opens into the far room.
    const double angle = random.uniform(0.1, 1.4);
    world.at(0.03, door_low + 0.04, angle)
        .reflecting(0.7)
        .box({0.0, -0.04, 0.008}, {door_width - 0.06, 0.0, door_top});
  }

  const Outline near_corners = near_room.outline();
  furnishWall(scene, random, near_corners[0], near_corners[1], random.uniform(0.1, 0.5));
  furnishWall(scene, random, near_corners[2], near_corners[3], random.uniform(0.1, 0.5));
  const Outline far_corners = far_room.outline();
  furnishWall(scene, random, far_corners[1], far_corners[2], random.uniform(0.1, 0.8));
  Clearances clearances;
  scatter(scene, random, {{0.9, -half_width + 0.5}, {far_depth - 0.5, half_width - 0.5}},
          random.integer(0, 5), clearances);

  const double door_middle = door_low + 0.5 * door_width;
  ViewArea approach;
  approach.centre = {-0.5 * near_depth, door_middle};
  approach.half_size = {0.5 * near_depth - 0.4, 0.35};
  approach.yaw_spread = 0.35;
  scene.view_areas.push_back(approach);
  ViewArea through = approach;
  through.centre = {-0.1, door_middle};
  through.half_size = {0.9, 0.05};
  scene.view_areas.push_back(through);
}

}  // namespace polygonal_perception::simulation

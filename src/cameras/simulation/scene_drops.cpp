// The scenes in which the robot's floor ends.
#include <cmath>

#include "cameras/simulation/room.hpp"
#include "cameras/simulation/scene_layouts.hpp"

namespace polygonal_perception::simulation {
namespace {

/// The way to the edge, which lies at x = 0.
ViewArea towardsTheEdge(double depth, double half_width)
{
  ViewArea area;
  area.centre = {-0.4 - 0.5 * (depth - 0.8), 0.0};
  area.half_size = {0.5 * (depth - 0.8), half_width - 0.5};
  area.yaw_spread = 0.6;
  return area;
}

}  // namespace

void layOutStairs(Scene& scene, Random& random)
{
  const double depth = random.uniform(2.5, 4.5);
  const double half_width = random.uniform(1.2, 2.5);
  const double half_stairs = random.chance(0.5) ? half_width : random.uniform(0.6, half_width - 0.3);
  const double rise = random.uniform(0.15, 0.19);
  const double tread = random.uniform(0.26, 0.32);
  const int steps = random.integer(6, 14);
  const double drop = rise * steps;
  const double landing = random.uniform(1.5, 4.0);
  const double length = tread * (steps - 1) + landing;
  const double height = random.uniform(2.4, 2.8);

  const Rectangle upper{{-depth, -half_width}, {0.0, half_width}};
  addFloor(scene, random, upper);
  addCeiling(scene, {{-depth, -half_width}, {length, half_width}}, height);
  RoomWalls walls;
  walls.missing[1] = true;
  addWalls(scene, upper, height, walls);

  const Assembly below = Assembly(scene.solids).of(Surface::kLowerFloor).reflecting(0.5);
  for (int step = 0; step < steps - 1; ++step) {
    const double top = -rise * (step + 1);
    below.box({tread * step, -half_stairs, top - rise - 0.05}, {tread * (step + 1), half_stairs, top});
  }
  // The riser under the robot's own floor.
  below.box({-0.1, -half_width, -drop}, {-0.001, half_width, -0.001});
  addLowerFloor(scene, {{tread * (steps - 1), -half_width}, {length, half_width}}, -drop);
  // The stairwell: walls at its sides from below up to the ceiling, beside the flight where it is narrower
  // than the room.
  const Assembly lower(scene.solids, Eigen::Isometry3d(Eigen::Translation3d(0, 0, -drop)));
  const double full = height + drop;
  addWall(lower, {0.0, -half_stairs}, {tread * (steps - 1), -half_stairs}, full);
  addWall(lower, {tread * (steps - 1), half_stairs}, {0.0, half_stairs}, full);
  addWall(lower, {tread * (steps - 1), -half_width}, {length, -half_width}, full);
  addWall(lower, {length, -half_width}, {length, half_width}, full);
  addWall(lower, {length, half_width}, {tread * (steps - 1), half_width}, full);
  if (half_stairs < half_width) {
    const Assembly world(scene.solids);
    addWall(world, {0.0, -half_width}, {0.0, -half_stairs}, height);
    addWall(world, {0.0, half_stairs}, {0.0, half_width}, height);
  }
  if (random.chance(0.5)) {
    // A handrail with its posts on the steps.
    const Assembly rail = Assembly(scene.solids).reflecting(0.5);
    const double y = random.sign() * (half_stairs - 0.06);
    rail.cylinder({0.0, y, 0.95}, {tread * (steps - 1), y, 0.95 - drop + rise}, 0.02);
    for (int step = 0; step < steps - 1; step += 3) {
      const double x = tread * (step + 0.5);
      rail.cylinder({x, y, -rise * (step + 1)}, {x, y, 0.95 - rise * (step + 0.5)}, 0.015);
    }
  }
  if (random.chance(0.5)) addBoxes(lower.at(length - 0.8, random.uniform(-0.5, 0.5) * half_width), random);
  furnishWall(scene, random, {-depth, -half_width}, {-0.3, -half_width}, random.uniform(0.0, 0.4));
  scene.view_areas.push_back(towardsTheEdge(depth, half_width));
}

void layOutLedge(Scene& scene, Random& random)
{
  const double depth = random.uniform(2.5, 4.5);
  const double half_width = random.uniform(1.8, 3.5);
  const double drop = random.uniform(0.5, 1.5);
  const double length = random.uniform(4.0, 8.0);
  const double height = random.uniform(2.6, 3.5);

  const Rectangle upper{{-depth, -half_width}, {0.0, half_width}};
  addFloor(scene, random, upper);
  addLowerFloor(scene, {{-0.2, -half_width}, {length, half_width}}, -drop);
  addCeiling(scene, {{-depth, -half_width}, {length, half_width}}, height);
  RoomWalls walls;
  walls.missing[1] = true;
  addWalls(scene, upper, height, walls);
  Assembly(scene.solids)
      .of(Surface::kLowerFloor)
      .box({-0.2, -half_width, -drop}, {-0.001, half_width, -0.001});

  const Assembly lower(scene.solids, Eigen::Isometry3d(Eigen::Translation3d(0, 0, -drop)));
  const double full = height + drop;
  addWall(lower, {0.0, -half_width}, {length, -half_width}, full);
  addWall(lower, {length, -half_width}, {length, half_width}, full, maybeWindow(random, 2.0 * half_width));
  addWall(lower, {length, half_width}, {0.0, half_width}, full);
  const int things = random.integer(1, 6);
  for (int i = 0; i < things; ++i) {
    const Assembly at = lower.at(random.uniform(0.8, length - 0.5), random.uniform(-0.8, 0.8) * half_width,
                                 random.uniform(-3.0, 3.0));
    switch (random.integer(0, 3)) {
      case 0:
        addDesk(at, random);
        break;
      case 1:
        addSofa(at, random);
        break;
      case 2:
        addChair(at, random);
        break;
      default:
        addBoxes(at, random);
    }
  }
  if (random.chance(0.3)) {
    // A railing: a handrail and its posts.
    const int posts = static_cast<int>((2.0 * half_width - 0.3) / 1.2) + 1;
    for (int post = 0; post < posts; ++post) {
      const double y = -half_width + 0.3 + 1.2 * post;
      Assembly(scene.solids).cylinder({-0.08, y, 0.0}, {-0.08, y, 1.0}, 0.02);
    }
    Assembly(scene.solids).cylinder({-0.08, -half_width, 1.0}, {-0.08, half_width, 1.0}, 0.02);
  }
  Clearances clearances;
  scatter(scene, random, {{-depth + 0.5, -half_width + 0.5}, {-0.6, half_width - 0.5}}, random.integer(0, 3),
          clearances);
  scene.view_areas.push_back(towardsTheEdge(depth, half_width));
}

}  // namespace polygonal_perception::simulation

// The scenes with a way that a robot drives, over more than the floor.
#include <cmath>

#include "cameras/simulation/room.hpp"
#include "cameras/simulation/scene_layouts.hpp"
#include "polygonal_perception/geometry/angle.hpp"

namespace polygonal_perception::simulation {
namespace {

constexpr double kBelow = 0.3;  // [m] ground that is raised reaches this far below its surface

/// Ground across a corridor that rises at a slope from a height at x, until its end.
struct Stretch
{
  double x;
  double end;
  double height;  // [m] at x
  double slope;   // [rad]
};

void addStretch(Scene& scene, const Stretch& stretch, double half_width, double reflectance)
{
  const double length = (stretch.end - stretch.x) / std::cos(stretch.slope);
  Assembly(scene.solids)
      .of(Surface::kGround)
      .reflecting(reflectance)
      .at(stretch.x, 0.0, 0.0, stretch.height)
      .turned(-stretch.slope, Eigen::Vector3d::UnitY())
      .box({0.0, -half_width, -kBelow}, {length, half_width, 0.0});
  const Eigen::Vector3d normal(-std::sin(stretch.slope), 0.0, std::cos(stretch.slope));
  const Rectangle area{{stretch.x, -half_width}, {stretch.end, half_width}};
  scene.grounds.push_back(
      {area.outline(), {normal, -normal.dot(Eigen::Vector3d(stretch.x, 0.0, stretch.height))}});
}

/// A ramp up to a height or down to one, and what it leads to.
/// @return where the level ground behind it ends
double addRamp(Scene& scene, Random& random, double x, double from, double to, double level_length,
               double half_width)
{
  const double slope = (to > from ? 1.0 : -1.0) * random.uniform(4.0, 7.0) * geometry::kDegree;
  const Stretch ramp{x, x + (to - from) / std::tan(slope), from, slope};
  addStretch(scene, ramp, half_width, random.uniform(0.4, 0.7));
  const double end = ramp.end + level_length;
  if (to > 0.0) addStretch(scene, {ramp.end, end, to, 0.0}, half_width, random.uniform(0.4, 0.7));
  return end;
}

}  // namespace

void layOutRamps(Scene& scene, Random& random)
{
  const double half_width = random.uniform(1.1, 1.4);
  const double rise = random.uniform(0.13, 0.2);
  const double kerb = random.uniform(0.06, 0.1);
  const double crest = addRamp(scene, random, 0.0, 0.0, rise, random.uniform(1.8, 2.5), half_width);
  const double foot = addRamp(scene, random, crest, rise, 0.0, random.uniform(1.8, 2.5), half_width);
  const double end = addRamp(scene, random, foot, 0.0, kerb, random.uniform(3.0, 4.0), half_width);

  constexpr double kStart = -5.5;
  constexpr double kHeight = 2.6;
  const Rectangle corridor{{kStart, -half_width}, {end, half_width}};
  addFloor(scene, random, corridor);
  addCeiling(scene, corridor, kHeight);
  addWalls(scene, corridor, kHeight);

  // A wall across it with a door; a way along the wall leads there.
  constexpr double kDoor = -2.5;
  constexpr double kDoorWidth = 0.95;
  constexpr double kDoorTop = 2.05;
  const double door_y = random.uniform(-0.3, 0.3);
  const double from_start = door_y - 0.5 * kDoorWidth + half_width;
  addWall(Assembly(scene.solids), {kDoor, -half_width}, {kDoor, half_width}, kHeight,
          {{from_start, from_start + kDoorWidth, 0.0, kDoorTop}});

  // Posts on the floor, both ramps and all that they lead to, now on one side and now on the other.
  const double side = half_width - 0.2;
  double sign = random.sign();
  for (const double x : {-0.9, 0.3 * crest, 0.8 * crest, 0.5 * (crest + foot) - 0.5, foot - 0.7, end - 1.8}) {
    const double z = scene.groundHeight({x, sign * side});
    const double height = random.uniform(0.25, 0.6);
    Assembly(scene.solids)
        .reflecting(random.uniform(0.4, 0.8))
        .at(x, sign * side, 0.0, z)
        .box({-0.06, -0.06, -0.05}, {0.06, 0.06, height});
    sign = -sign;
  }

  const double beside_wall = -half_width + 0.5;
  for (const Eigen::Vector2d& place :
       {Eigen::Vector2d(kStart + 0.6, beside_wall), Eigen::Vector2d(kDoor - 0.8, beside_wall),
        Eigen::Vector2d(kDoor - 0.7, door_y), Eigen::Vector2d(kDoor + 0.9, door_y),
        Eigen::Vector2d(-0.9, 0.0), Eigen::Vector2d(end - 0.6, 0.0)}) {
    scene.way.push_back({place, 0.0});
  }
  ViewArea before;
  before.centre = {-1.4, 0.0};
  before.half_size = {0.5, 0.3};
  before.yaw_spread = 0.4;
  scene.view_areas.push_back(before);
}

}  // namespace polygonal_perception::simulation

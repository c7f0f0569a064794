// The scenes that play in one ordinary room.
#include <algorithm>
#include <cmath>

#include "cameras/simulation/room.hpp"
#include "cameras/simulation/route.hpp"
#include "cameras/simulation/scene_layouts.hpp"
#include "polygonal_perception/geometry/angle.hpp"
#include "polygonal_perception/geometry/ring_view.hpp"

namespace polygonal_perception::simulation {
namespace {

constexpr double kWalkerRadius = 0.35;  // [m] somebody who walks keeps clear of things by this
constexpr double kLongestWalk = 3.0;    // [m]

/// A room around the origin with a ceiling, and with windows in all walls but, if asked, the one at the high
/// x.
Rectangle addRoom(Scene& scene, Random& random, const Eigen::Vector2d& size, bool window_ahead = true)
{
  Rectangle room{-0.5 * size, 0.5 * size};
  addFloor(scene, random, room);
  const double height = random.uniform(2.4, 3.0);
  addCeiling(scene, room, height);
  RoomWalls walls;
  for (int i = 0; i < 4; ++i) walls.openings[i] = maybeWindow(random, i % 2 == 0 ? size.x() : size.y());
  if (!window_ahead) walls.openings[1].clear();
  addWalls(scene, room, height, walls);
  return room;
}

Rectangle shrunk(const Rectangle& area, double by)
{
  return {area.low + Eigen::Vector2d::Constant(by), area.high - Eigen::Vector2d::Constant(by)};
}

void furnishAllWalls(Scene& scene, Random& random, const Rectangle& room, double density)
{
  const Outline corners = room.outline();
  for (const auto [from, to] : geometry::RingView(corners).edges())
    furnishWall(scene, random, from, to, density);
}

ViewArea everywhere(const Rectangle& room)
{
  ViewArea area;
  area.centre = room.centre();
  area.half_size = 0.5 * room.size();
  area.yaw_spread = geometry::kPi;
  return area;
}

void addWorkplace(Scene& scene, Random& random, Clearances& clearances, const Eigen::Vector2d& centre,
                  double yaw)
{
  const Assembly desk = Assembly(scene.solids).at(centre.x(), centre.y(), yaw);
  const HalfSize half = addDesk(desk, random);
  for (const double side : {-0.5, 0.5}) {
    clearances.reserve(centre + side * half.y() * Eigen::Vector2d(-std::sin(yaw), std::cos(yaw)), 0.55);
  }
  const double away = half.x() + random.uniform(0.0, 0.5);
  const double aside = random.uniform(-0.3, 0.3);
  addChair(desk.at(away, aside, geometry::kPi + random.uniform(-1.0, 1.0)), random);
  clearances.reserve(centre + away * Eigen::Vector2d(std::cos(yaw), std::sin(yaw)), 0.4);
  if (random.chance(0.7))
    addCable(desk.at(0.0, random.uniform(-0.5, 0.5), random.uniform(-1.0, 1.0)), random,
             random.uniform(0.5, 2.5));
  if (random.chance(0.4))
    addBag(desk.at(random.uniform(-0.1, 0.5), random.sign() * half.y() * 0.6,
                   random.uniform(-geometry::kPi, geometry::kPi)),
           random);
}

}  // namespace

void layOutOffice(Scene& scene, Random& random)
{
  const Rectangle room = addRoom(scene, random, {random.uniform(5.5, 8.5), random.uniform(5.0, 7.5)});
  const Outline corners = room.outline();
  Clearances clearances;
  // Desks stand along two walls or in the middle, the other walls carry cupboards.
  for (const auto [from, to] : geometry::RingView(corners).edges()) {
    const Eigen::Vector2d way = to - from;
    const Eigen::Vector2d along = way.normalized();
    const Eigen::Vector2d inwards(-along.y(), along.x());
    if (!random.chance(0.5)) {
      furnishWall(scene, random, from, to, random.uniform(0.3, 0.9));
      continue;
    }
    for (double done = random.uniform(1.2, 1.8); done + 1.8 < way.norm(); done += random.uniform(2.0, 3.0)) {
      const double away = random.uniform(0.4, 0.6);
      addWorkplace(scene, random, clearances, from + along * done + inwards * away,
                   std::atan2(inwards.y(), inwards.x()));
    }
  }
  if (random.chance(0.5)) {
    const double yaw = random.integer(0, 1) * geometry::kPi / 2;
    const Eigen::Vector2d side(std::cos(yaw), std::sin(yaw));
    addWorkplace(scene, random, clearances, room.centre() + 0.42 * side, yaw);
    addWorkplace(scene, random, clearances, room.centre() - 0.42 * side, yaw + geometry::kPi);
  }
  const Rectangle inner = shrunk(room, 0.7);
  if (random.chance(0.5))
    addMat(Assembly(scene.solids)
               .at(room.centre().x(), room.centre().y(), random.uniform(-geometry::kPi, geometry::kPi)),
           random);
  scatter(scene, random, inner, random.integer(4, 12), clearances);
  if (random.chance(0.3)) {
    PersonPose visitor;
    visitor.position = {random.uniform(inner.low.x(), inner.high.x()),
                        random.uniform(inner.low.y(), inner.high.y())};
    visitor.yaw = random.uniform(-geometry::kPi, geometry::kPi);
    visitor.stature = random.uniform(1.55, 1.92);
    if (clearances.take(visitor.position, 0.35)) addPerson(scene.solids, visitor);
  }
  scene.view_areas.push_back(everywhere(shrunk(room, 0.5)));
}

void layOutBusyOffice(Scene& scene, Random& random)
{
  layOutOffice(scene, random);
  const FreeSpace space(scene, kWalkerRadius, 0.0, 2.0);
  Walker walker;
  walker.speed = random.uniform(0.5, 1.2);
  walker.stature = random.uniform(1.55, 1.92);
  // The longest of many short ways: a robot has to find room beside it.
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector2d from = drawPose(space, scene.view_areas[0], random).position;
    const Eigen::Vector2d to = drawPose(space, scene.view_areas[0], random).position;
    const double length = (to - from).norm();
    if (length > kLongestWalk || length < (walker.to - walker.from).norm()) continue;
    if (!space.containsSegment(from, to)) continue;
    walker.from = from;
    walker.to = to;
  }
  scene.walkers.push_back(walker);
}

void layOutPerson(Scene& scene, Random& random)
{
  const Rectangle room = addRoom(scene, random, {random.uniform(6.0, 10.0), random.uniform(4.5, 7.0)});
  furnishAllWalls(scene, random, room, random.uniform(0.1, 0.5));
  const int people = random.integer(1, 3);
  // They walk in front of the camera, which keeps to the low x; some across, some towards it.
  for (int i = 0; i < people; ++i) {
    Walker walker;
    walker.speed = random.uniform(0.6, 1.5);
    walker.stature = random.uniform(1.55, 1.92);
    const double lane = room.low.x() + 2.4 + 1.0 * i;
    const double reach = 0.5 * room.size().y() - 0.9;
    walker.from = {lane, -reach * random.uniform(0.6, 1.0)};
    walker.to = {lane + random.uniform(0.0, 0.4), reach * random.uniform(0.6, 1.0)};
    if (random.chance(0.4)) walker.to = {room.high.x() - 0.9, walker.from.y() + random.uniform(-0.3, 0.3)};
    if (random.chance(0.5)) std::swap(walker.from, walker.to);
    walker.start = random.uniform(0.0, 8.0);
    scene.walkers.push_back(walker);
  }
  Clearances clearances;
  scatter(scene, random, {{room.high.x() - 1.8, room.low.y() + 0.8}, room.high - Eigen::Vector2d(0.8, 0.8)},
          random.integer(0, 3), clearances);
  ViewArea area;
  area.centre = {room.low.x() + 1.1, 0.0};
  area.half_size = {0.5, 0.5 * room.size().y() - 0.9};
  area.yaw_spread = 0.6;
  scene.view_areas.push_back(area);
}

void layOutTableTop(Scene& scene, Random& random)
{
  const Rectangle room = addRoom(scene, random, {random.uniform(8.0, 10.0), random.uniform(5.0, 7.0)});
  furnishAllWalls(scene, random, room, random.uniform(0.2, 0.6));
  // A coffee table for low cameras in one half of the room, a large table for high ones in the other.
  for (const bool low : {true, false}) {
    const HalfSize half = low ? HalfSize(random.uniform(0.35, 0.6), random.uniform(0.55, 0.9))
                              : HalfSize(random.uniform(0.4, 0.75), random.uniform(0.7, 1.2));
    const double height = low ? random.uniform(0.28, 0.38) : random.uniform(0.70, 0.78);
    const Eigen::Vector2d centre(room.low.x() + 1.7 + half.x(), (low ? -0.25 : 0.25) * room.size().y());
    const Assembly at = Assembly(scene.solids).at(centre.x(), centre.y());
    addTable(at, random, half, height);
    if (random.chance(0.7)) {
      const HalfSize far_part(0.6 * half.x(), half.y());
      addTableClutter(at.at(0.4 * half.x(), 0.0), random, far_part, height, random.integer(0, 3));
    }
    if (random.chance(0.5))
      addChair(at.at(half.x() + 0.3, random.uniform(-0.4, 0.4), geometry::kPi + random.uniform(-0.4, 0.4)),
               random);
    // From over the near part of the table and from right behind its edge.
    ViewArea area;
    area.centre = centre - Eigen::Vector2d(0.75 * half.x() + 0.22, 0.0);
    area.half_size = {0.25 * half.x() + 0.22, 0.5 * half.y()};
    area.yaw_spread = 0.3;
    area.min_camera_height = height + 0.12;
    area.max_camera_height = height + (low ? 0.4 : 0.65);
    scene.view_areas.push_back(area);
  }
  if (random.chance(0.5))
    addSofa(Assembly(scene.solids).at(room.high.x() - 1.2, random.uniform(-1.0, 1.0), geometry::kPi), random);
  Clearances clearances;
  scatter(scene, random, {{room.low.x() + 4.6, room.low.y() + 0.8}, room.high - Eigen::Vector2d(1.2, 0.8)},
          random.integer(0, 5), clearances);
}

void layOutWall(Scene& scene, Random& random)
{
  const Rectangle room = addRoom(scene, random, {random.uniform(4.0, 7.0), random.uniform(4.0, 6.0)}, false);
  const double face = room.high.x();
  const Assembly wall = Assembly(scene.solids).at(face, 0.0, geometry::kPi);
  // The wall is bare, or carries pictures, a board or a radiator.
  const double y = random.uniform(-1.0, 1.0);
  switch (random.integer(0, 3)) {
    case 0:
      break;
    case 1:
      wall.box({0.0, y - 0.4, 1.0}, {0.025, y + 0.4, 1.7});
      break;
    case 2:
      wall.box({0.0, y - 0.9, 0.8}, {0.04, y + 0.9, 2.0});
      break;
    default:
      addRadiator(wall.at(0.07, y), random);
  }
  if (random.chance(0.5)) addSmallThing(wall.at(0.35, random.sign() * random.uniform(0.5, 1.2)), random);
  ViewArea area;
  area.centre = {face - random.uniform(0.8, 1.1), 0.0};
  area.half_size = {0.3, 0.5 * room.size().y() - 0.8};
  area.yaw_spread = 0.45;
  scene.view_areas.push_back(area);
}

}  // namespace polygonal_perception::simulation

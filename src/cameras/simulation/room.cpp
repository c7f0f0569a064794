#include "cameras/simulation/room.hpp"

#include <algorithm>
#include <cmath>

#include "polygonal_perception/geometry/ring_view.hpp"

namespace polygonal_perception::simulation {
namespace {

constexpr double kThickness = 0.15;
constexpr double kBaseboardHeight = 0.08;
constexpr double kBaseboardDepth = 0.015;

}  // namespace

void addWall(const Assembly& at, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double height,
             const std::vector<Opening>& openings)
{
  const Eigen::Vector2d way = to - from;
  const double length = way.norm();
  const Assembly along = at.at(from.x(), from.y(), std::atan2(way.y(), way.x())).reflecting(0.75);
  const auto piece = [&](double start, double end, double bottom, double top) {
    if (end - start < 1e-3 || top - bottom < 1e-3) return;
    along.box({start, -kThickness, bottom}, {end, 0.0, top});
    if (bottom <= 0.0) along.box({start, 0.0, 0.0}, {end, kBaseboardDepth, kBaseboardHeight});
  };
  double done = 0.0;
  for (const Opening& opening : openings) {
    piece(done, opening.start, 0.0, height);
    piece(opening.start, opening.end, 0.0, opening.bottom);
    piece(opening.start, opening.end, opening.top, height);
    done = opening.end;
  }
  piece(done, length, 0.0, height);
}

void addFloor(Scene& scene, Random& random, const Rectangle& area)
{
  const double tile = random.uniform(0.8, 2.0);
  const double reflectance = random.uniform(0.3, 0.6);
  const Eigen::Vector2i count = (area.size() / tile).array().ceil().cast<int>();
  for (int i = 0; i < count.x(); ++i) {
    for (int j = 0; j < count.y(); ++j) {
      const Eigen::Vector2d low = area.low + tile * Eigen::Vector2d(i, j);
      Solid piece =
          makeLevelRectangle(low, (area.low + tile * Eigen::Vector2d(i + 1, j + 1)).cwiseMin(area.high), 0.0);
      piece.surface = Surface::kFloor;
      piece.reflectance =
          static_cast<float>(random.chance(0.03) ? 0.06 : reflectance * random.uniform(0.8, 1.2));
      scene.solids.push_back(std::move(piece));
    }
  }
  scene.floor.push_back(area.outline());
}

void addLowerFloor(Scene& scene, const Rectangle& area, double z)
{
  Solid floor = makeLevelRectangle(area.low, area.high, z);
  floor.surface = Surface::kLowerFloor;
  floor.reflectance = 0.5F;
  scene.solids.push_back(std::move(floor));
}

void addCeiling(Scene& scene, const Rectangle& area, double height)
{
  Solid ceiling = makeLevelRectangle(area.low, area.high, height);
  ceiling.reflectance = 0.8F;
  scene.solids.push_back(std::move(ceiling));
}

void addWalls(Scene& scene, const Rectangle& area, double height, const RoomWalls& walls)
{
  const Outline corners = area.outline();
  const Assembly world(scene.solids);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto [from, to] = geometry::RingView(corners).edge(i);
    if (!walls.missing[i]) addWall(world, from, to, height, walls.openings[i]);
  }
}

std::vector<Opening> maybeWindow(Random& random, double wall_length)
{
  if (wall_length < 2.0 || !random.chance(0.4)) return {};
  const double width = random.uniform(0.8, std::min(2.5, wall_length - 0.6));
  const double start = random.uniform(0.3, wall_length - width - 0.3);
  return {{start, start + width, random.uniform(0.8, 1.0), random.uniform(1.9, 2.2)}};
}

bool Clearances::take(const Eigen::Vector2d& centre, double radius)
{
  const bool free = std::all_of(discs_.begin(), discs_.end(), [&](const Disc& disc) {
    return (disc.centre - centre).norm() >= disc.radius + radius;
  });
  if (free) reserve(centre, radius);
  return free;
}

void furnishWall(Scene& scene, Random& random, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                 double density)
{
  const Eigen::Vector2d way = to - from;
  const double length = way.norm();
  const Eigen::Vector2d along = way / length;
  const Eigen::Vector2d inwards(-along.y(), along.x());
  const double yaw = std::atan2(inwards.y(), inwards.x());
  double done = 0.6 + random.uniform(0.0, 0.4);
  while (done + 1.7 < length) {
    if (!random.chance(density)) {
      done += random.uniform(0.4, 1.2);
      continue;
    }
    // Built at the origin first: only then is its size known.
    std::vector<Solid> thing;
    const Assembly origin(thing);
    const int kind = random.integer(0, 5);
    const HalfSize half = kind <= 2   ? addCabinet(origin, random)
                          : kind == 3 ? addRadiator(origin, random)
                          : kind == 4 ? addBoxes(origin, random)
                                      : addSmallThing(origin, random);
    const Eigen::Vector2d centre = from + along * (done + half.y()) + inwards * (half.x() + 0.03);
    const Eigen::Isometry3f pose(
        (Eigen::Translation3d(centre.x(), centre.y(), 0.0) * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()))
            .cast<float>());
    for (Solid& solid : thing) {
      for (Eigen::Vector3f& vertex : solid.vertices) vertex = pose * vertex;
      scene.solids.push_back(std::move(solid));
    }
    done += 2.0 * half.y() + random.uniform(0.02, 0.5);
  }
}

void scatter(Scene& scene, Random& random, const Rectangle& area, int count, Clearances& clearances)
{
  const Assembly world(scene.solids);
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector2d centre(random.uniform(area.low.x(), area.high.x()),
                                 random.uniform(area.low.y(), area.high.y()));
    if (!clearances.take(centre, 0.35)) continue;
    const Assembly at = world.at(centre.x(), centre.y(), random.uniform(-3.14, 3.14));
    switch (random.integer(0, 4)) {
      case 0:
        addChair(at, random);
        break;
      case 1:
        addBoxes(at, random);
        break;
      case 2:
        addBag(at, random);
        break;
      case 3:
        addSmallThing(at, random);
        break;
      default:
        addCable(at, random, random.uniform(0.6, 3.0));
    }
  }
}

}  // namespace polygonal_perception::simulation

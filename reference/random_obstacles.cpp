#include "reference/random_obstacles.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "polygonal_perception/geometry/predicates.hpp"
#include "polygonal_perception/geometry/validity.hpp"

namespace polygonal_perception::reference {

namespace {

using Ring = std::vector<Eigen::Vector2d>;

double between(std::mt19937& random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

Eigen::Vector2d rastered(const Eigen::Vector2d& point, Raster raster)
{
  if (raster == Raster::kFloat) return point.cast<float>().cast<double>();
  return {std::round(4.0 * point.x()) / 4.0, std::round(4.0 * point.y()) / 4.0};
}

/// Points at changing distances around a middle.
Ring star(std::mt19937& random)
{
  const int count = std::uniform_int_distribution<int>(3, 10)(random);
  const double radius = between(random, 0.2, 1.8);
  const double spikes = between(random, 0.2, 1.0);
  const double begin = between(random, 0.0, 6.3);
  Ring ring;
  for (int i = 0; i < count; ++i) {
    const double angle = begin + 2.0 * EIGEN_PI * i / count;
    ring.push_back(radius * between(random, spikes, 1.0) * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

/// A U of three walls, open to one side.
Ring bay(std::mt19937& random)
{
  const double width = between(random, 0.8, 3.0);
  const double depth = between(random, 0.8, 3.0);
  const double wall = between(random, 0.25, 0.35);
  return {{0, 0},       {width, 0},    {width, depth}, {width - wall, depth}, {width - wall, wall},
          {wall, wall}, {wall, depth}, {0, depth}};
}

void place(std::mt19937& random, double size, Raster raster, Ring& ring)
{
  const Eigen::Rotation2Dd turn(raster == Raster::kCoarse
                                    ? 0.5 * EIGEN_PI * std::uniform_int_distribution<int>(0, 3)(random)
                                    : between(random, 0.0, 6.3));
  const Eigen::Vector2d shift(between(random, 0.0, size), between(random, 0.0, size));
  Ring placed;
  for (const Eigen::Vector2d& point : ring) {
    const Eigen::Vector2d there = rastered(turn * point + shift, raster);
    if (placed.empty() || (there != placed.back() && there != placed.front())) placed.push_back(there);
  }
  ring = placed;
}

}  // namespace

Eigen::Vector2d randomPoint(std::mt19937& random, double low, double high, Raster raster)
{
  return rastered({between(random, low, high), between(random, low, high)}, raster);
}

geometry::PolygonSet randomObstacles(std::mt19937& random, std::size_t count, double size, Raster raster)
{
  geometry::PolygonSet obstacles;
  if (random() % 3 == 0) {
    obstacles.append(Ring{{-1, -1}, {size + 1, -1}, {size + 1, size + 1}, {-1, size + 1}}, false);
    obstacles.append(Ring{{-0.5, -0.5}, {-0.5, size + 0.5}, {size + 0.5, size + 0.5}, {size + 0.5, -0.5}},
                     true);
  }
  for (std::size_t i = 0; i < count; ++i) {
    Ring ring = random() % 4 == 0 ? bay(random) : star(random);
    place(random, size, raster, ring);
    if (ring.size() < 3 ||
        geometry::orientation(geometry::RingView(ring)) != geometry::Orientation::kCounterClockwise)
      continue;
    geometry::PolygonSet with = obstacles;
    with.append(ring, false);
    if (!geometry::findDefect(with)) obstacles = std::move(with);
  }
  return obstacles;
}

}  // namespace polygonal_perception::reference

#include "reference/broken_obstacles.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "reference/random_obstacles.hpp"

namespace polygonal_perception::reference {

namespace {

using geometry::PolygonSet;
using Ring = std::vector<Eigen::Vector2d>;

constexpr double kSize = 8.0;  // [m]

std::size_t upTo(std::mt19937& random, std::size_t most)
{
  return std::uniform_int_distribution<std::size_t>(0, most)(random);
}

Raster anyRaster(std::mt19937& random)
{
  return random() % 2 == 0 ? Raster::kCoarse : Raster::kFloat;
}

double oddNumber(std::mt19937& random)
{
  using Limits = std::numeric_limits<double>;
  constexpr double kOdd[] = {
      Limits::quiet_NaN(), Limits::infinity(), 1e300, -1e9, 2e8, 1e7, Limits::denorm_min(), 0.0};
  return kOdd[upTo(random, std::size(kOdd) - 1)];
}

/// By some of a number's last digits.
void nudge(std::mt19937& random, Eigen::Vector2d& point)
{
  double& number = random() % 2 == 0 ? point.x() : point.y();
  for (std::size_t i = upTo(random, 3); i > 0; --i)
    number = std::nextafter(number, random() % 2 == 0 ? kSize : -kSize);
}

/// Points in any order: such rings cross themselves.
Ring scribble(std::mt19937& random)
{
  const Raster raster = anyRaster(random);
  Ring ring(upTo(random, 9));
  for (Eigen::Vector2d& point : ring) point = randomPoint(random, 0.0, kSize, raster);
  return ring;
}

void damage(std::mt19937& random, Ring& ring)
{
  if (ring.empty()) return;
  Eigen::Vector2d& some = ring[upTo(random, ring.size() - 1)];
  const Eigen::Vector2d other = ring[upTo(random, ring.size() - 1)];
  switch (random() % 8) {
    case 0:
      std::reverse(ring.begin(), ring.end());
      break;
    case 1:
      some = other;
      break;
    case 2:
      nudge(random, some);
      break;
    case 3:
      ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(upTo(random, ring.size())), other);
      break;
    case 4:
      some = randomPoint(random, 0.0, kSize, anyRaster(random));
      break;
    case 5:
      for (Eigen::Vector2d& point : ring) point.x() += 0.25;
      break;
    case 6:
      some = 0.5 * (other + ring.front());
      break;
    default:
      if (random() % 8 == 0) some.y() = oddNumber(random);
  }
}

}  // namespace

PolygonSet brokenObstacles(std::mt19937& random)
{
  const PolygonSet whole = randomObstacles(random, 1 + upTo(random, 8), kSize, anyRaster(random));
  PolygonSet broken;
  const auto append = [&](const Ring& ring, bool hole) {
    // The message's reader refuses shorter ones.
    if (ring.size() >= 3) broken.append(ring, hole && !broken.rings.empty());
  };
  for (const PolygonSet::Ring& ring : whole.rings) {
    const geometry::RingView view = whole.view(ring);
    Ring copy(view.begin(), view.end());
    for (int i = random() % 3 == 0 ? 1 + static_cast<int>(upTo(random, 2)) : 0; i > 0; --i)
      damage(random, copy);
    append(copy, random() % 16 == 0 ? !ring.hole : ring.hole);
    if (random() % 16 == 0) append(copy, random() % 2 == 0);
  }
  if (random() % 3 == 0) append(scribble(random), random() % 4 == 0);
  return broken;
}

Eigen::Vector2d brokenPlace(std::mt19937& random, const PolygonSet& obstacles)
{
  Eigen::Vector2d place = randomPoint(random, -2.0, kSize + 2.0, anyRaster(random));
  const std::size_t kind = random() % 8;
  if (kind < 3 && !obstacles.vertices.empty()) {
    const std::size_t i = upTo(random, obstacles.vertices.size() - 1);
    place = obstacles.vertices[i];
    if (kind == 1) place = 0.5 * (place + obstacles.vertices[(i + 1) % obstacles.vertices.size()]);
    if (kind == 2) nudge(random, place);
  }
  if (random() % 64 == 0) place.x() = oddNumber(random);
  return place;
}

}  // namespace polygonal_perception::reference

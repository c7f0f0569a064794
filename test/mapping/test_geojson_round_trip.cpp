#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "polygonal_perception/geometry/measures.hpp"
#include "polygonal_perception/geometry/predicates.hpp"
#include "polygonal_perception/geometry/validity.hpp"
#include "polygonal_perception/mapping/geojson.hpp"
#include "polygonal_perception/occupancy/grid/inflation.hpp"
#include "polygonal_perception/occupancy/polygons/polygonizer.hpp"
#include "reference/random_grids.hpp"
#include "support/same_map.hpp"

namespace polygonal_perception::mapping {
namespace {

void expectRoundTrip(const MapFile& map)
{
  const auto text = writeGeoJson(map);
  const auto* const written = std::get_if<std::string>(&text);
  ASSERT_NE(written, nullptr) << std::get<MapFileError>(text).text;
  const auto read = readGeoJson(*written);
  const auto* const again = std::get_if<MapFile>(&read);
  ASSERT_NE(again, nullptr) << std::get<MapFileError>(read).text << "\nin " << *written;
  EXPECT_EQ(test::difference(map, *again), "") << "of " << *written;
}

/// A map as perception makes them, of cells and the polygons around them, moved to where no number is round.
MapFile randomMap(std::mt19937& random, int largest)
{
  std::uniform_int_distribution<int> side(1, largest);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  const double resolution = random() % 2 == 0 ? 0.05 : 0.01 + 0.1 * std::abs(share(random));
  const occupancy::BinaryGrid grid =
      reference::randomGrid(random(), side(random), side(random), resolution, random);
  MapFile map;
  map.frame_id = random() % 5 == 0 ? "" : "map_" + std::to_string(random());
  map.inflation_radius = resolution * static_cast<double>(random() % 5);
  occupancy::BinaryGrid inflated;
  inflated.reset(grid.geometry());
  occupancy::Inflation({map.inflation_radius}).inflate(grid, inflated);
  occupancy::Polygonizer({resolution * static_cast<double>(random() % 4)})
      .polygonize(grid, inflated, map.inflation_radius, map.polygons);
  if (random() % 2 == 0) {
    const double magnitude = std::pow(10.0, 4.0 * share(random));
    const Eigen::Isometry2d pose =
        Eigen::Translation2d(magnitude * share(random), magnitude * share(random)) *
        Eigen::Rotation2Dd(M_PI * share(random));
    map.polygons = geometry::transformed(map.polygons, pose);
  }
  if (random() % 3 == 0) return map;
  map.cells = SavedCells{grid.cellsX(), grid.cellsY(), resolution, share(random), 1e3 * share(random), {}};
  map.cells->layers.push_back({"occupied", {grid.cells().begin(), grid.cells().end()}});
  map.cells->layers.push_back({"noise", std::vector<std::uint8_t>(grid.cells().size())});
  for (std::uint8_t& value : map.cells->layers.back().values) value = static_cast<std::uint8_t>(random());
  return map;
}

TEST(GeoJsonRoundTrip, RandomMaps)
{
  std::mt19937 random(1);
  int invalid = 0;
  std::size_t vertices = 0;
  for (int n = 0; n < 10'000 && !HasFailure(); ++n) {
    SCOPED_TRACE("map " + std::to_string(n));
    const MapFile map = randomMap(random, n % 50 == 0 ? 100 : 32);
    if (geometry::findDefect(map.polygons)) {  // moving them has rounded their vertices
      ++invalid;
      continue;
    }
    vertices += map.polygons.vertices.size();
    expectRoundTrip(map);
  }
  EXPECT_LT(invalid, 50);
  EXPECT_GT(vertices, 50'000U);
}

/// A double of any pattern of bits that findFault accepts.
double anyCoordinate(std::mt19937_64& random)
{
  while (true) {
    const std::uint64_t bits = random();
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof value);
    if (std::abs(value) >= 1e-100 && std::abs(value) <= 1e100) return value;
  }
}

TEST(GeoJsonRoundTrip, NumbersOfAnyPatternOfBits)
{
  std::mt19937_64 random(2);
  for (int n = 0; n < 20'000 && !HasFailure(); ++n) {
    std::vector<Eigen::Vector2d> triangle(3);
    for (Eigen::Vector2d& vertex : triangle) vertex = {anyCoordinate(random), anyCoordinate(random)};
    if (geometry::orientation(triangle) != geometry::Orientation::kCounterClockwise)
      std::swap(triangle[1], triangle[2]);
    MapFile map;
    map.polygons.append(triangle, false);
    map.inflation_radius = std::abs(anyCoordinate(random));
    map.cells = SavedCells{1, 1, map.inflation_radius, anyCoordinate(random), -0.0, {}};
    expectRoundTrip(map);
  }
}

TEST(GeoJsonRoundTrip, NumbersAtTheEdges)
{
  using Limits = std::numeric_limits<double>;
  for (const double value :
       {0.0, Limits::denorm_min(), Limits::min(), std::nextafter(Limits::min(), 0.0),
        std::nextafter(1.0, 2.0), 0x1p53, 0x1p53 + 2, 0x1p63, 0x1p64, 1e22, 1e23, Limits::max()}) {
    MapFile map;
    map.inflation_radius = value;
    map.cells = SavedCells{1, 1, 1.0, value, -value, {}};
    expectRoundTrip(map);
  }
}

TEST(GeoJsonRoundTrip, LongRunsAndManyLayers)
{
  MapFile map;
  map.cells = SavedCells{100, 200, 0.05, 0.0, 0.0, {}};
  for (int k = 0; k < 1000; ++k) {
    map.cells->layers.push_back(
        {std::to_string(k), std::vector<std::uint8_t>(20'000, static_cast<std::uint8_t>(k))});
    map.cells->layers.back().values[static_cast<std::size_t>(k)] = 77;
  }
  expectRoundTrip(map);
}

TEST(GeoJsonRoundTrip, AsManyVerticesAsThereMayBe)
{
  MapFile map;
  for (std::size_t k = 0; k < kMostSavedVertices / 4; ++k) {
    const auto x = static_cast<double>(k);
    map.polygons.append(std::vector<Eigen::Vector2d>{{x, 0}, {x + 0.5, 0}, {x + 0.5, 1}, {x, 1}}, false);
  }
  expectRoundTrip(map);
}

}  // namespace
}  // namespace polygonal_perception::mapping

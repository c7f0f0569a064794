#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mapping/drawn_cells.hpp"
#include "polygonal_perception/geometry/distance.hpp"
#include "polygonal_perception/geometry/location.hpp"

namespace polygonal_perception::mapping {
namespace {

using Vertices = std::vector<Eigen::Vector2d>;

/// A star around a place, some of whose corners lie on the lattice.
Vertices star(const Eigen::Vector2d& middle, double least, double most, bool clockwise, std::mt19937& random)
{
  std::uniform_real_distribution<double> radius(least, most);
  Vertices vertices;
  const int corners = 3 + static_cast<int>(random() % 10);
  for (int k = 0; k < corners; ++k) {
    const double angle = (clockwise ? -2.0 : 2.0) * M_PI * k / corners;
    Eigen::Vector2d vertex = middle + radius(random) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    if (random() % 3 == 0) vertex = (10.0 * vertex.array()).round() / 10.0;
    vertices.push_back(vertex);
  }
  return vertices;
}

/// [m] How far a square is from the polygons, by points along its border and in it; 0 where one is inside.
double distanceOf(const geometry::PolygonSet& polygons, const Eigen::Vector2d& corner, double side)
{
  constexpr int kSteps = 8;
  double least = 1e9;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const Eigen::Vector2d p = corner + side / kSteps * Eigen::Vector2d(i, j);
      if (geometry::locate(p, polygons) != geometry::Location::kOutside) return 0.0;
      least = std::min(least, geometry::distanceToBoundary(p, polygons));
    }
  }
  return least;
}

TEST(DrawnCells, AreThoseThatPolygonsReachInto)
{
  constexpr double kResolution = 0.1;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-2.0, 2.0);
  for (int round = 0; round < 60; ++round) {
    geometry::PolygonSet polygons;
    const Eigen::Vector2d middle(place(random), place(random));
    polygons.append(star(middle, 0.5, 1.0, false, random), false);
    if (round % 2 == 0) polygons.append(star(middle, 0.1, 0.25, true, random), true);
    polygons.append(star(middle + Eigen::Vector2d(2.5, 0.0), 0.02, 0.4, false, random), false);
    const auto drawing = drawCells(polygons, kResolution);
    ASSERT_TRUE(std::holds_alternative<DrawnCells>(drawing)) << std::get<MapFileError>(drawing).text;
    const auto& drawn = std::get<DrawnCells>(drawing);
    for (int j = -1; j <= drawn.geometry.cells_y; ++j) {
      for (int i = -1; i <= drawn.geometry.cells_x; ++i) {
        const Eigen::Vector2d corner = Eigen::Vector2d(drawn.geometry.origin_x, drawn.geometry.origin_y) +
                                       kResolution * Eigen::Vector2d(i, j);
        const auto cell =
            drawn.geometry.cellOf(corner.x() + 0.5 * kResolution, corner.y() + 0.5 * kResolution);
        const bool is_drawn = cell && drawn.cells[*cell] != 0;
        const double distance = distanceOf(polygons, corner, kResolution);
        if (distance == 0.0) {
          EXPECT_TRUE(is_drawn) << "round " << round << ", cell at " << corner.transpose();
        }
        // A corner of a polygon may reach in between the points that were looked at.
        if (is_drawn) {
          EXPECT_LT(distance, 0.1 * kResolution) << "round " << round << ", cell at " << corner.transpose();
        }
      }
    }
  }
}

TEST(DrawnCells, OfASquareOnTheLatticeAreItsOwnAndThoseItTouches)
{
  geometry::PolygonSet polygons;
  polygons.append(Vertices{{0, 0}, {0.4, 0}, {0.4, 0.4}, {0, 0.4}}, false);
  const auto drawn = std::get<DrawnCells>(drawCells(polygons, 0.1));
  EXPECT_EQ(drawn.geometry.cells_x, 6);
  EXPECT_EQ(drawn.geometry.cells_y, 6);
  EXPECT_EQ(drawn.cells, std::vector<std::uint8_t>(36, 1));
}

TEST(DrawnCells, OfNothingAreNone)
{
  const auto drawn = std::get<DrawnCells>(drawCells({}, 0.1));
  EXPECT_EQ(std::count(drawn.cells.begin(), drawn.cells.end(), 1), 0);
}

/// A comb of narrow teeth, `width` x `height` cells of a metre.
geometry::PolygonSet comb(int teeth, double width, double height)
{
  Vertices vertices = {{width, -1.0}, {width, 0.0}};
  for (int k = teeth - 1; k >= 0; --k) {
    vertices.emplace_back(width * (k + 0.5) / teeth, height);
    vertices.emplace_back(width * k / teeth, 0.0);
  }
  vertices.emplace_back(0.0, -1.0);
  geometry::PolygonSet polygons;
  polygons.append(vertices, false);
  return polygons;
}

TEST(DrawnCells, OfAHostileFileAreDrawnInSecondsOrRefused)
{
  const auto drawing = drawCells(comb(4'000, 1900, 1900), 1.0);
  EXPECT_TRUE(std::holds_alternative<DrawnCells>(drawing));
  const auto refused = drawCells(comb(300'000, 1900, 1900), 1.0);
  ASSERT_TRUE(std::holds_alternative<MapFileError>(refused));
  EXPECT_EQ(std::get<MapFileError>(refused).text,
            "the edges of the polygons run through more than 2e7 cells");
  const auto far = drawCells(comb(2, 3000, 3000), 1.0);
  ASSERT_TRUE(std::holds_alternative<MapFileError>(far));
  EXPECT_EQ(std::get<MapFileError>(far).text, "the polygons reach over more than 4e6 cells");
}

}  // namespace
}  // namespace polygonal_perception::mapping

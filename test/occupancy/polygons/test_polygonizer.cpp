#include <gtest/gtest.h>

#include "polygonal_perception/occupancy/polygons/polygonizer.hpp"
#include "support/grid_from_text.hpp"

namespace polygonal_perception::occupancy {
namespace {

using Corners = std::vector<std::pair<double, double>>;

geometry::PolygonSet polygonize(const std::vector<std::string>& cells, double tolerance = 0.0)
{
  Polygonizer::Parameters parameters;
  parameters.simplification_tolerance = tolerance;
  const BinaryGrid grid = test::gridFromText(cells);
  geometry::PolygonSet polygons;
  Polygonizer(parameters).polygonize(grid, grid, 0.0, polygons);
  return polygons;
}

Corners corners(const geometry::PolygonSet& polygons, std::size_t ring)
{
  Corners result;
  for (std::uint32_t n = 0; n < polygons.rings.at(ring).size; ++n) {
    const Eigen::Vector2d& vertex = polygons.vertices.at(polygons.rings[ring].first + n);
    result.emplace_back(vertex.x(), vertex.y());
  }
  return result;
}

TEST(Polygonizer, EmptyGridHasNoPolygons)
{
  EXPECT_TRUE(polygonize({"...", "..."}).rings.empty());
}

TEST(Polygonizer, FullGridIsItsRectangleCounterClockwise)
{
  const geometry::PolygonSet polygons = polygonize({"###", "###"});
  ASSERT_EQ(polygons.rings.size(), 1U);
  EXPECT_EQ(corners(polygons, 0), (Corners{{0, 0}, {3, 0}, {3, 2}, {0, 2}}));
}

TEST(Polygonizer, HoleIsClockwiseAndFollowsItsBoundary)
{
  const geometry::PolygonSet polygons =
      polygonize({"#########.#", "#.......#..", "#.......#..", "#.......#..", "#########.#"});
  ASSERT_EQ(polygons.rings.size(), 4U);
  EXPECT_FALSE(polygons.rings[0].hole);
  ASSERT_TRUE(polygons.rings[1].hole);
  EXPECT_EQ(corners(polygons, 1), (Corners{{1, 1}, {1, 4}, {8, 4}, {8, 1}}));
  EXPECT_FALSE(polygons.rings[2].hole);
  EXPECT_FALSE(polygons.rings[3].hole);
}

}  // namespace
}  // namespace polygonal_perception::occupancy

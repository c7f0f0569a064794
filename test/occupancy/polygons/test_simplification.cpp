#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <utility>

#include "occupancy/polygons/simplification.hpp"
#include "support/drawn_outlines.hpp"
#include "support/noise_grid.hpp"

namespace polygonal_perception::occupancy {
namespace {

using test::Corners;
using test::cornersOf;
using test::inCells;

constexpr std::size_t kAny = SIZE_MAX;  // no number of vertices is too many

/// Simplifies with no limit but the grid's border.
void simplify(const BitGrid& occupied, double max_added_area, std::size_t enough, Outlines& outlines)
{
  BitGrid none;
  none.reset(occupied.cellsX(), occupied.cellsY());
  Proximity proximity;
  proximity.setLimit(occupied.cellsX() + occupied.cellsY(), -1.0);
  proximity.setCells(occupied, none);
  Simplification().simplify(occupied.cellsX(), occupied.cellsY(), max_added_area, enough, proximity,
                            outlines);
}

Outlines simplified(const std::vector<std::string>& cells, double max_added_area, std::size_t enough = kAny)
{
  Outlines outlines = test::traced(cells);
  simplify(test::bitsFromText(cells), max_added_area, enough, outlines);
  return outlines;
}

TEST(Simplification, AddsUpToTheAreaThatAVertexIsWorth)
{
  // Cutting off the inner corner adds half a cell, and squaring the bevel that is left another half.
  const std::vector<std::string> cells = {"#.", "##"};
  EXPECT_EQ(simplified(cells, 0.49).rings[0].size, 6U);
  EXPECT_EQ(cornersOf(simplified(cells, 0.5), 0), inCells({{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
}

TEST(Simplification, ForNothingItTakesStraightVertices)
{
  Outlines outlines = test::outlinesThrough({inCells({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}})});
  simplify(test::bitsFromText({"##", "##"}), 0.0, kAny, outlines);
  EXPECT_EQ(cornersOf(outlines, 0), inCells({{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
}

TEST(Simplification, LeavesATriangleAtLeast)
{
  const Corners triangle = inCells({{0, 0}, {3, 0}, {0, 3}});
  Outlines outlines = test::outlinesThrough({triangle});
  simplify(test::bitsFromText({"#..", "##.", "###"}), 1000.0, 0, outlines);
  EXPECT_EQ(cornersOf(outlines, 0), triangle);
}

TEST(Simplification, TheCheapestGoesFirst)
{
  // A bowl with two inner corners. The left one costs 7680, after which the right one costs more than it is
  // worth; had the right one gone first, both would be gone.
  const Corners bowl = {{320, 560}, {64, 600}, {0, 640}, {0, 0}, {640, 0}, {640, 640}};
  Outlines outlines = test::outlinesThrough({bowl});
  simplify(test::bitsFromText(std::vector<std::string>(10, "##########")), 34000.0 / 8192.0, kAny, outlines);
  EXPECT_EQ(cornersOf(outlines, 0), (Corners{{320, 560}, {0, 640}, {0, 0}, {640, 0}, {640, 640}}));
}

// Two notches on one side: the left one is 1 cell deep and costs 2, the right one 1.5 cells deep, and costs
// 3.
const Corners kNotches = {{0, 0},     {640, 0},   {640, 640}, {512, 544},
                          {384, 640}, {256, 640}, {128, 576}, {0, 640}};

Corners withoutNotches(double max_added_area, std::size_t enough)
{
  Outlines outlines = test::outlinesThrough({kNotches});
  simplify(test::bitsFromText(std::vector<std::string>(10, "##########")), max_added_area, enough, outlines);
  return cornersOf(outlines, 0);
}

TEST(Simplification, DearerOnesGoWhereThereAreTooManyVertices)
{
  EXPECT_EQ(withoutNotches(1.0, 8).size(), 8U) << "there are few enough";
  EXPECT_EQ(withoutNotches(1.0, 7),
            (Corners{{0, 0}, {640, 0}, {640, 640}, {512, 544}, {384, 640}, {256, 640}, {0, 640}}))
      << "the cheaper one goes, and then there are few enough";
}

TEST(Simplification, ButNotAtAnyPrice)
{
  // At most five times what a vertex is worth.
  EXPECT_EQ(withoutNotches(0.39, 0).size(), 8U);
  EXPECT_EQ(withoutNotches(0.41, 0).size(), 6U) << "and what is straight then";
  EXPECT_EQ(withoutNotches(0.61, 0).size(), 4U);
}

const std::vector<std::string> kFrame = {"####", "#..#", "#..#", "####"};

TEST(Simplification, GivesUpASmallHole)
{
  // 4 cells for 4 vertices.
  const Outlines kept = simplified(kFrame, 0.99);
  EXPECT_EQ(kept.rings[1].size, 4U);
  const Outlines filled = simplified(kFrame, 1.0);
  EXPECT_EQ(filled.rings[1].size, 0U);
  EXPECT_EQ(filled.rings[0].size, 4U);
}

TEST(Simplification, GivesUpNoHoleWithSomethingInIt)
{
  const Outlines outlines = simplified({"#####", "#...#", "#.#.#", "#...#", "#####"}, 100.0, 0);
  ASSERT_EQ(outlines.rings.size(), 3U);
  for (const Outlines::Ring& ring : outlines.rings) EXPECT_EQ(ring.size, 4U);
}

TEST(Simplification, CountsTheVerticesOfHolesThatAreGivenUp)
{
  // With the hole gone there are few enough, and the dear notch on the upper side stays.
  const std::vector<std::string> cells = {"##..##", "##..##", "##..##", "######", "#.####", "######"};
  const Outlines outlines = simplified(cells, 0.7, 8);
  EXPECT_EQ(outlines.rings[1].size, 0U);
  EXPECT_EQ(outlines.rings[0].size, 8U);
}

/// Even-odd over all rings.
bool isInside(const Outlines& outlines, LatticePoint p)
{
  bool inside = false;
  for (std::size_t r = 0; r < outlines.rings.size(); ++r) {
    const Corners corners = cornersOf(outlines, r);
    for (std::size_t n = 0; n < corners.size(); ++n) {
      LatticePoint a = corners[n];
      LatticePoint b = corners[(n + 1) % corners.size()];
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if (a.y > b.y) std::swap(a, b);
      if (cross(a, b, p) > 0) inside = !inside;
    }
  }
  return inside;
}

TEST(Simplification, TakesNoGroundAway)
{
  std::mt19937 random(20201024);
  std::size_t before = 0;
  std::size_t after = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const BinaryGrid grid = test::noiseGrid(20, 14, trial % 2 == 0 ? 0.1 : 0.5, random);
    const BitGrid cells = test::bitsOf(grid);
    Outlines outlines = test::traced(cells);
    before += outlines.vertices.size();
    simplify(cells, 0.5 * (1 + trial % 8), trial % 3 == 0 ? 0 : kAny, outlines);
    after += test::verticesOf(outlines);
    for (int k = 0; k < 20 * 14; ++k) {
      if (!grid.occupied(k % 20, k / 20)) continue;
      // Points of the cell, all but at its border.
      for (const std::int32_t dx : {1, 32, 63}) {
        for (const std::int32_t dy : {1, 32, 63}) {
          const LatticePoint point{k % 20 * kUnitsPerCell + dx, k / 20 * kUnitsPerCell + dy};
          ASSERT_TRUE(isInside(outlines, point))
              << testing::PrintToString(point) << ", of " << testing::PrintToString(test::textFromGrid(grid));
        }
      }
    }
    for (const Outlines::Ring& ring : outlines.rings)
      ASSERT_TRUE(ring.size == 0 || ring.size >= 3) << ring.size;
  }
  EXPECT_LT(after, before / 2);
}

}  // namespace
}  // namespace polygonal_perception::occupancy

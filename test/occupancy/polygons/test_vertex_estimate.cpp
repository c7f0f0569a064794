#include <gtest/gtest.h>

#include <random>

#include "occupancy/polygons/vertex_estimate.hpp"
#include "support/drawn_outlines.hpp"
#include "support/noise_grid.hpp"

namespace polygonal_perception::occupancy {
namespace {

using test::Corners;
using test::inCells;

std::size_t estimate(const Corners& ring, double tolerance)
{
  return estimateVertices(test::outlinesThrough({ring}), tolerance);
}

const Corners kSquare = inCells({{0, 0}, {10, 0}, {10, 10}, {0, 10}});

TEST(VertexEstimate, ASquareTakesItsCorners)
{
  EXPECT_EQ(estimate(kSquare, 0.0), 4U);
  EXPECT_EQ(estimate(kSquare, 1.0), 4U);
}

TEST(VertexEstimate, NoRingTakesLessThanThree)
{
  EXPECT_EQ(estimate(inCells({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), 5.0), 3U);
}

TEST(VertexEstimate, RingsAddUp)
{
  EXPECT_EQ(estimateVertices(test::outlinesThrough({kSquare, kSquare, kSquare}), 1.0), 12U);
  EXPECT_EQ(estimateVertices(Outlines{}, 1.0), 0U);
}

TEST(VertexEstimate, ABumpCountsWhereItIsHigherThanTheTolerance)
{
  // One cell high in the middle of the lower side: a line from the corner may leave it to one side.
  const Corners bump = inCells({{0, 0}, {10, 0}, {12, -1}, {14, 0}, {24, 0}, {24, 10}, {0, 10}});
  EXPECT_EQ(estimate(bump, 1.1), 4U);
  EXPECT_EQ(estimate(bump, 0.1), 7U);
}

TEST(VertexEstimate, ALineMayPassCornersOnEitherSide)
{
  // A side that swings half a cell out and half a cell in. A line that ends in one of its corners leaves the
  // others by up to 0.83 cells.
  const Corners swinging = {{0, 0}, {160, -32}, {320, 32}, {480, -32}, {640, 0}, {640, 640}, {0, 640}};
  EXPECT_EQ(estimate(swinging, 0.85), 4U);
  EXPECT_EQ(estimate(swinging, 0.05), 7U);
  // To the left as to the right.
  Corners mirrored = swinging;
  for (LatticePoint& corner : mirrored) corner.y = -corner.y;
  for (int n = 0; n < 20; ++n)
    EXPECT_EQ(estimate(mirrored, 0.05 * n), estimate(swinging, 0.05 * n)) << "tolerance " << 0.05 * n;
}

TEST(VertexEstimate, TheStepsOfASlantedOutlineAreOneLine)
{
  std::vector<std::string> cells;
  for (std::size_t n = 1; n <= 20; ++n) cells.push_back(std::string(n, '#') + std::string(20 - n, '.'));
  const Outlines outlines = test::traced(cells);
  ASSERT_EQ(outlines.rings[0].size, 42U);
  EXPECT_EQ(estimateVertices(outlines, 0.0), 42U);
  EXPECT_LE(estimateVertices(outlines, 0.75), 5U) << "about a triangle";
}

TEST(VertexEstimate, WithoutToleranceEveryCornerCounts)
{
  std::mt19937 random(20201024);
  for (int trial = 0; trial < 100; ++trial) {
    const BinaryGrid grid = test::noiseGrid(20, 12, 0.3, random);
    const Outlines outlines = test::traced(test::bitsOf(grid));
    ASSERT_EQ(estimateVertices(outlines, 0.0), outlines.vertices.size())
        << testing::PrintToString(test::textFromGrid(grid));
  }
}

}  // namespace
}  // namespace polygonal_perception::occupancy

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <random>
#include <set>
#include <utility>

#include "polygonal_perception/occupancy/polygons/outline_tracer.hpp"
#include "support/cell_regions.hpp"
#include "support/drawn_outlines.hpp"
#include "support/noise_grid.hpp"

namespace polygonal_perception::occupancy {
namespace {

using test::cornersOf;
using test::inCells;
using test::traced;

constexpr std::int32_t kGap = Outlines::kCornerGap;

TEST(OutlineTracer, AFreeGridHasNone)
{
  const Outlines outlines = traced({"...", "..."});
  EXPECT_TRUE(outlines.rings.empty());
  EXPECT_TRUE(outlines.vertices.empty());
}

TEST(OutlineTracer, ACellIsItsSquareCounterClockwise)
{
  const Outlines outlines = traced({"...", ".#.", "..."});
  ASSERT_EQ(outlines.rings.size(), 1U);
  EXPECT_EQ(cornersOf(outlines, 0), inCells({{1, 1}, {2, 1}, {2, 2}, {1, 2}}));
  EXPECT_FALSE(outlines.rings[0].hole);
  EXPECT_EQ(outlines.rings[0].parent, Outlines::kNone);
  EXPECT_FALSE(outlines.rings[0].has_nested_ring);
}

TEST(OutlineTracer, TurnsInwardsAtAnInnerCorner)
{
  EXPECT_EQ(cornersOf(traced({"#.", "##"}), 0), inCells({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}));
  EXPECT_EQ(cornersOf(traced({"##", ".#"}), 0), inCells({{1, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 1}, {1, 1}}));
}

TEST(OutlineTracer, ANarrowBridgeJoinsCellsThatMeetInACorner)
{
  // At (64, 64) both stretches give way into the free cells.
  const Outlines falling = traced({"#.", ".#"});
  ASSERT_EQ(falling.rings.size(), 1U);
  EXPECT_EQ(cornersOf(falling, 0), (test::Corners{{64, 0},
                                                  {128, 0},
                                                  {128, 64},
                                                  {64 + kGap, 64 + kGap},
                                                  {64, 128},
                                                  {0, 128},
                                                  {0, 64},
                                                  {64 - kGap, 64 - kGap}}));
  const Outlines rising = traced({".#", "#."});
  ASSERT_EQ(rising.rings.size(), 1U);
  EXPECT_EQ(cornersOf(rising, 0), (test::Corners{{0, 0},
                                                 {64, 0},
                                                 {64 + kGap, 64 - kGap},
                                                 {128, 64},
                                                 {128, 128},
                                                 {64, 128},
                                                 {64 - kGap, 64 + kGap},
                                                 {0, 64}}));
}

TEST(OutlineTracer, CellsThatMeetInCornersEncloseAHole)
{
  const Outlines outlines = traced({".#.", "#.#", ".#."});
  ASSERT_EQ(outlines.rings.size(), 2U);
  EXPECT_TRUE(outlines.rings[1].hole);
  EXPECT_EQ(cornersOf(outlines, 1), (test::Corners{{64 + kGap, 64 + kGap},
                                                   {64 + kGap, 128 - kGap},
                                                   {128 - kGap, 128 - kGap},
                                                   {128 - kGap, 64 + kGap}}));
}

TEST(OutlineTracer, AHoleRunsClockwiseAndLiesInItsBoundary)
{
  const Outlines outlines = traced({"###", "#.#", "###"});
  ASSERT_EQ(outlines.rings.size(), 2U);
  EXPECT_EQ(cornersOf(outlines, 0), inCells({{0, 0}, {3, 0}, {3, 3}, {0, 3}}));
  EXPECT_TRUE(outlines.rings[0].has_nested_ring);
  EXPECT_EQ(cornersOf(outlines, 1), inCells({{1, 1}, {1, 2}, {2, 2}, {2, 1}}));
  EXPECT_TRUE(outlines.rings[1].hole);
  EXPECT_EQ(outlines.rings[1].parent, 0U);
  EXPECT_FALSE(outlines.rings[1].has_nested_ring);
}

TEST(OutlineTracer, ARingInAHoleInARingLiesInTheHole)
{
  const Outlines outlines =
      traced({"#######", "#.....#", "#.###.#", "#.#.#.#", "#.###.#", "#.....#", "#######"});
  ASSERT_EQ(outlines.rings.size(), 4U);
  const std::vector<std::uint32_t> parents = {Outlines::kNone, 0, 1, 2};
  for (std::size_t r = 0; r < 4; ++r) {
    EXPECT_EQ(outlines.rings[r].hole, r % 2 == 1) << "ring " << r;
    EXPECT_EQ(outlines.rings[r].parent, parents[r]) << "ring " << r;
    EXPECT_EQ(outlines.rings[r].has_nested_ring, r < 3) << "ring " << r;
  }
}

TEST(OutlineTracer, HolesSideBySideHaveOneBoundary)
{
  const Outlines outlines = traced({"#######.#", "#.#.#.#.#", "#######.#"});
  ASSERT_EQ(outlines.rings.size(), 5U);
  for (const std::size_t hole : {2U, 3U, 4U}) {
    EXPECT_TRUE(outlines.rings[hole].hole) << "ring " << hole;
    EXPECT_EQ(outlines.rings[hole].parent, 0U) << "ring " << hole;
  }
  EXPECT_FALSE(outlines.rings[1].hole) << "what stands beside it is on its own";
  EXPECT_EQ(outlines.rings[1].parent, Outlines::kNone);
}

TEST(OutlineTracer, AFullGridIsItsRectangle)
{
  for (const int width : {1, 48, 63, 64, 65, 128, 130}) {
    const Outlines outlines =
        traced(std::vector<std::string>(2, std::string(static_cast<std::size_t>(width), '#')));
    ASSERT_EQ(outlines.rings.size(), 1U) << "width " << width;
    EXPECT_EQ(cornersOf(outlines, 0), inCells({{0, 0}, {width, 0}, {width, 2}, {0, 2}}));
  }
}

TEST(OutlineTracer, FindsACellWhereverItStandsInAWord)
{
  for (int x = 0; x < 130; ++x) {
    std::string row(130, '.');
    row[static_cast<std::size_t>(x)] = '#';
    EXPECT_EQ(cornersOf(traced({row}), 0), inCells({{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}}));
  }
}

TEST(OutlineTracer, FindsWhatACellLiesInWordsAway)
{
  const std::string wall(200, '#');
  const std::string free = '#' + std::string(198, '.') + '#';
  for (std::size_t x = 2; x < 198; ++x) {
    std::string row = free;
    row[x] = '#';
    const Outlines outlines = traced({wall, free, row, free, wall});
    ASSERT_EQ(outlines.rings.size(), 3U) << "cell " << x;
    EXPECT_EQ(outlines.rings[2].parent, 1U) << "cell " << x;
  }
}

TEST(OutlineTracer, ForgetsTheLastGrid)
{
  OutlineTracer tracer;
  Outlines outlines;
  tracer.trace(test::bitsFromText({"###"}), outlines);
  tracer.trace(test::bitsFromText({"###", "#.#", "###"}), outlines);
  ASSERT_EQ(outlines.rings.size(), 2U);
  EXPECT_EQ(outlines.vertices.size(), 8U);
  EXPECT_EQ(outlines.rings[1].parent, 0U);
}

/// The outlines of a random grid, held against the grid's regions.
class RandomOutlines
{
public:
  explicit RandomOutlines(const BinaryGrid& grid)
      : grid_(grid), regions_(grid), outlines_(traced(test::bitsOf(grid)))
  {
  }

  void check()
  {
    int boundaries = 0;
    for (std::uint32_t r = 0; r < outlines_.rings.size(); ++r) {
      checkClosed(outlines_.rings[r]);
      follow(r);
      boundaries += outlines_.rings[r].hole ? 0 : 1;
    }
    EXPECT_EQ(boundaries, regions_.occupiedRegions());
    EXPECT_EQ(static_cast<int>(outlines_.rings.size()) - boundaries, regions_.enclosedFreeRegions());
    EXPECT_EQ(length_, borders()) << "sides between an occupied cell and a free one";
    checkParents();
    for (const auto& [region, area] : area_of_) EXPECT_EQ(area, regions_.size(region)) << "cells of a region";
    checkDistinct();
  }

private:
  void checkClosed(const Outlines::Ring& ring) const
  {
    std::uint32_t vertex = ring.start;
    for (std::uint32_t n = 0; n < ring.size; ++n) {
      const std::uint32_t next = outlines_.vertices.at(vertex).next;
      ASSERT_EQ(outlines_.vertices.at(next).previous, vertex);
      vertex = next;
    }
    EXPECT_EQ(vertex, ring.start);
  }

  /// Walks along a ring: one occupied region lies to its left, one free region to its right.
  void follow(std::uint32_t r)
  {
    test::Corners corners = cornersOf(outlines_, r);
    for (LatticePoint& corner : corners) {  // without the gaps, in cells
      corner.x = (corner.x + kUnitsPerCell / 2) / kUnitsPerCell;
      corner.y = (corner.y + kUnitsPerCell / 2) / kUnitsPerCell;
    }
    const std::int64_t area = test::twiceArea(corners) / 2;
    EXPECT_EQ(area < 0, outlines_.rings[r].hole) << "area " << area;
    std::set<int> left;
    std::set<int> right;
    for (std::size_t n = 0; n < corners.size(); ++n) {
      LatticePoint a = corners[n];
      const LatticePoint b = corners[(n + 1) % corners.size()];
      const int dx = (b.x > a.x ? 1 : 0) - (b.x < a.x ? 1 : 0);
      const int dy = (b.y > a.y ? 1 : 0) - (b.y < a.y ? 1 : 0);
      ASSERT_EQ(std::abs(dx) + std::abs(dy), 1) << "an edge runs along x or along y";
      for (; !(a == b); a = {a.x + dx, a.y + dy}, ++length_) {
        // The cells to the left and to the right of the side from a on.
        const int left_i = a.x - (dx < 0 || dy > 0 ? 1 : 0);
        const int left_j = a.y - (dy < 0 || dx < 0 ? 1 : 0);
        ASSERT_TRUE(regions_.occupied(left_i, left_j)) << "cell (" << left_i << ", " << left_j << ")";
        ASSERT_FALSE(regions_.occupied(left_i + dy, left_j - dx));
        left.insert(regions_.at(left_i, left_j));
        right.insert(regions_.at(left_i + dy, left_j - dx));
      }
    }
    ASSERT_EQ(left.size(), 1U);
    ASSERT_EQ(right.size(), 1U);
    inside_.push_back(*left.begin());
    outside_.push_back(*right.begin());
    area_of_[*left.begin()] += static_cast<int>(area);
  }

  /// A hole lies in the boundary of the region around it, a boundary in the hole that is the space around it.
  void checkParents() const
  {
    std::vector<bool> has_nested_ring(outlines_.rings.size(), false);
    for (std::size_t r = 0; r < outlines_.rings.size(); ++r) {
      const Outlines::Ring& ring = outlines_.rings[r];
      std::uint32_t expected = Outlines::kNone;
      for (std::uint32_t other = 0; other < outlines_.rings.size(); ++other) {
        if (outlines_.rings[other].hole == ring.hole) continue;
        if ((ring.hole ? inside_ : outside_)[r] == (ring.hole ? inside_ : outside_)[other]) expected = other;
      }
      EXPECT_EQ(ring.parent, expected) << "parent of ring " << r;
      if (expected == Outlines::kNone) continue;
      EXPECT_LT(expected, r) << "the parent stands before the child";
      has_nested_ring[expected] = true;
    }
    for (std::size_t r = 0; r < outlines_.rings.size(); ++r)
      EXPECT_EQ(outlines_.rings[r].has_nested_ring, has_nested_ring[r]) << "ring " << r;
  }

  void checkDistinct() const
  {
    std::set<std::pair<std::int32_t, std::int32_t>> places;
    for (const Outlines::Vertex& vertex : outlines_.vertices) {
      EXPECT_TRUE(places.emplace(vertex.at.x, vertex.at.y).second)
          << "two vertices in " << testing::PrintToString(vertex.at);
    }
  }

  int borders() const
  {
    int count = 0;
    for (int j = -1; j < grid_.cellsY(); ++j) {
      for (int i = -1; i < grid_.cellsX(); ++i) {
        count += regions_.occupied(i, j) != regions_.occupied(i + 1, j) ? 1 : 0;
        count += regions_.occupied(i, j) != regions_.occupied(i, j + 1) ? 1 : 0;
      }
    }
    return count;
  }

  BinaryGrid grid_;
  test::CellRegions regions_;
  Outlines outlines_;
  std::vector<int> inside_;   // of a ring, the occupied region along it
  std::vector<int> outside_;  // the free one
  std::map<int, int> area_of_;
  int length_ = 0;
};

TEST(OutlineTracer, AgreesWithFloodFillOnRandomGrids)
{
  std::mt19937 random(20201024);
  for (int trial = 0; trial < 600; ++trial) {
    const int cells_x = std::uniform_int_distribution<>(1, trial % 4 == 0 ? 140 : 24)(random);
    const int cells_y = std::uniform_int_distribution<>(1, 16)(random);
    const double density = std::uniform_real_distribution<>(0.05, 0.95)(random);
    const BinaryGrid grid = test::noiseGrid(cells_x, cells_y, density, random);
    ASSERT_NO_FATAL_FAILURE(RandomOutlines(grid).check());
    ASSERT_FALSE(testing::Test::HasFailure())
        << "trial " << trial << ": " << testing::PrintToString(test::textFromGrid(grid));
  }
}

}  // namespace
}  // namespace polygonal_perception::occupancy

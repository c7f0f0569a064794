#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "occupancy/polygons/proximity.hpp"
#include "support/bits_from_text.hpp"
#include "support/drawn_outlines.hpp"
#include "support/noise_grid.hpp"

namespace polygonal_perception::occupancy {
namespace {

constexpr std::int32_t kCell = kUnitsPerCell;

/// A limit round drawn cells. No cell counts as covered unless it is said so.
class Limit
{
public:
  Limit(double limit, const std::vector<std::string>& occupied) : Limit(limit, 0.0, occupied, freed(occupied))
  {
  }
  Limit(double limit, double margin, const std::vector<std::string>& occupied,
        const std::vector<std::string>& covered)
      : occupied_(test::bitsFromText(occupied)), covered_(test::bitsFromText(covered))
  {
    proximity_.setLimit(limit, margin);
    proximity_.setCells(occupied_, covered_);
  }

  bool covers(LatticePoint a, LatticePoint b, LatticePoint c) { return proximity_.covers(a, b, c); }

private:
  static std::vector<std::string> freed(std::vector<std::string> cells)
  {
    for (std::string& row : cells) std::replace(row.begin(), row.end(), '#', '.');
    return cells;
  }

  BitGrid occupied_;
  BitGrid covered_;
  Proximity proximity_;
};

const std::vector<std::string> kOneCell = {".......", ".......", ".......", "...#...",
                                           ".......", ".......", "......."};

TEST(Proximity, OneCellAccountsForWhatIsWithinTheLimit)
{
  // The cell's right side is x = 4 cells; the triangle's tip is at the limit, or a unit farther.
  Limit limit(2.0, kOneCell);
  const std::int32_t at_limit = 6 * kCell;
  EXPECT_TRUE(limit.covers({at_limit, 220}, {at_limit - 50, 250}, {at_limit - 50, 200}));
  EXPECT_FALSE(limit.covers({at_limit + 1, 220}, {at_limit - 50, 250}, {at_limit - 50, 200}));
}

TEST(Proximity, TheLimitIsRoundAtTheCellsCorners)
{
  // 3 : 4 : 5 from the cell's upper right corner.
  Limit limit(1.25, kOneCell);
  const LatticePoint corner{4 * kCell, 4 * kCell};
  const LatticePoint at_limit{corner.x + 48, corner.y + 64};
  EXPECT_TRUE(limit.covers(at_limit, {corner.x, corner.y + 30}, corner));
  EXPECT_FALSE(limit.covers({at_limit.x + 1, at_limit.y}, {corner.x, corner.y + 30}, corner));
  EXPECT_FALSE(limit.covers({at_limit.x, at_limit.y + 1}, {corner.x, corner.y + 30}, corner));
}

TEST(Proximity, SeveralCellsAccountForALongTriangle)
{
  // Along a wall: no cell is near to both ends.
  const LatticePoint left{0, kCell};
  const LatticePoint right{16 * kCell, kCell};
  const LatticePoint above{8 * kCell, 2 * kCell};
  EXPECT_TRUE(
      Limit(1.5, {"................", "................", "################"}).covers(left, right, above));
  EXPECT_FALSE(
      Limit(1.5, {"................", "................", "####........####"}).covers(left, right, above))
      << "the middle is far from all";
}

TEST(Proximity, ASmallGapBetweenCellsIsNoMatter)
{
  EXPECT_TRUE(Limit(1.5, {"................", "................", "#######..#######"})
                  .covers({0, kCell}, {16 * kCell, kCell}, {8 * kCell, 80}));
}

TEST(Proximity, NothingIsNearInAFreeGrid)
{
  EXPECT_FALSE(Limit(50.0, {"...", "..."}).covers({0, 0}, {64, 0}, {0, 64}));
}

TEST(Proximity, ATriangleWithoutAreaIsNoGround)
{
  Limit limit(1.0, kOneCell);
  EXPECT_TRUE(limit.covers({0, 0}, {10, 10}, {20, 20}));
  EXPECT_FALSE(limit.covers({0, 0}, {10, 10}, {20, 21}));
}

TEST(Proximity, TakesCoveredCellsForNear)
{
  // Not a cell is occupied: only the word for the covered ones is left.
  Limit limit(2.0, 0.0, {"....", "....", "...."}, {"....", ".##.", "...."});
  EXPECT_TRUE(limit.covers({64, 64}, {192, 64}, {192, 128}));
  EXPECT_FALSE(limit.covers({64, 64}, {193, 64}, {192, 128}));
  EXPECT_FALSE(limit.covers({63, 64}, {192, 64}, {192, 128}));
  EXPECT_FALSE(limit.covers({64, 64}, {192, 64}, {192, 129}));
  EXPECT_FALSE(limit.covers({64, 63}, {192, 64}, {192, 128}));
}

TEST(Proximity, TakesNoCellBeyondTheWordForCovered)
{
  const std::string free(70, '.');
  std::string covered = free;
  covered.replace(62, 2, "##");
  Limit limit(2.0, 0.0, {free}, {covered});
  EXPECT_TRUE(limit.covers({62 * kCell, 0}, {64 * kCell, 0}, {62 * kCell, 64}));
  EXPECT_FALSE(limit.covers({62 * kCell, 0}, {65 * kCell, 0}, {62 * kCell, 64}));
}

TEST(Proximity, AMarginWidensTheCoveredCells)
{
  const std::vector<std::string> free(5, "......");
  const std::vector<std::string> covered = {"......", "......", "..#...", "......", "......"};
  Limit limit(3.0, 1.4, free, covered);
  EXPECT_TRUE(limit.covers({64, 128}, {4 * 64, 128}, {128, 192})) << "one cell to each side";
  EXPECT_FALSE(limit.covers({63, 128}, {4 * 64, 128}, {128, 192}));
  EXPECT_FALSE(Limit(3.0, 0.9, free, covered).covers({64, 128}, {4 * 64, 128}, {128, 192}));
}

TEST(Proximity, WithANegativeMarginCoveredCellsSayNothing)
{
  const std::vector<std::string> free(3, "...");
  Limit limit(0.5, -0.1, free, {"...", ".#.", "..."});
  EXPECT_FALSE(limit.covers({64, 64}, {128, 64}, {64, 128}));
}

TEST(Proximity, ForgetsTheWitnessOfOtherCells)
{
  const BitGrid occupied = test::bitsFromText({"#.."});
  const BitGrid free = test::bitsFromText({"..."});
  Proximity proximity;
  proximity.setLimit(1.0, 0.0);
  proximity.setCells(occupied, free);
  ASSERT_TRUE(proximity.covers({64, 0}, {100, 0}, {64, 30}));
  proximity.setCells(free, free);
  EXPECT_FALSE(proximity.covers({64, 0}, {100, 0}, {64, 30}));
}

TEST(Proximity, TakesOnAnotherLimit)
{
  const BitGrid occupied = test::bitsFromText({"#......"});
  const BitGrid free = test::bitsFromText({"......."});
  Proximity proximity;
  for (const double limit : {2.0, 1.0, 2.0}) {
    proximity.setLimit(limit, 0.0);
    proximity.setCells(occupied, free);
    EXPECT_EQ(proximity.covers({64, 0}, {64 + 128, 0}, {64, 30}), limit == 2.0) << "limit " << limit;
  }
}

TEST(Proximity, FindsACellWhereverItStandsInAWord)
{
  for (int x = 3; x < 137; ++x) {
    std::string row(140, '.');
    row[static_cast<std::size_t>(x)] = '#';
    Limit limit(2.0, {row});
    const std::int32_t left = (x - 2) * kCell;
    const std::int32_t right = (x + 3) * kCell;
    EXPECT_TRUE(limit.covers({left, 0}, {left + 30, 0}, {left, 64})) << "to the left of cell " << x;
    EXPECT_FALSE(limit.covers({left - 1, 0}, {left + 30, 0}, {left, 64})) << "to the left of cell " << x;
    EXPECT_TRUE(limit.covers({right, 0}, {right, 64}, {right - 30, 0})) << "to the right of cell " << x;
    EXPECT_FALSE(limit.covers({right + 1, 0}, {right, 64}, {right - 30, 0})) << "to the right of cell " << x;
  }
}

/// A grid with what can be said of distances in it by looking at every cell.
struct PlainDistances
{
  /// [cells] Of a point from the nearest occupied square.
  double toCells(double x, double y) const
  {
    double least = HUGE_VAL;
    for (int k = 0; k < grid.cellsX() * grid.cellsY(); ++k) {
      if (grid.cells()[static_cast<std::size_t>(k)] == 0) continue;
      least = std::min(least, to(k % grid.cellsX(), k / grid.cellsX(), x, y));
    }
    return least;
  }
  /// From one square.
  static double to(int i, int j, double x, double y)
  {
    return std::hypot(std::max({0.0, i - x, x - i - 1}), std::max({0.0, j - y, y - j - 1}));
  }
  /// The cells of which every point is within a distance of one occupied square.
  BinaryGrid cellsWithin(double distance) const
  {
    BinaryGrid result(grid.geometry());
    for (int k = 0; k < grid.cellsX() * grid.cellsY(); ++k) {
      for (int l = 0; l < grid.cellsX() * grid.cellsY(); ++l) {
        if (grid.cells()[static_cast<std::size_t>(l)] == 0) continue;
        // The square's far corner decides.
        const double dx = std::abs(k % grid.cellsX() - l % grid.cellsX());
        const double dy = std::abs(k / grid.cellsX() - l / grid.cellsX());
        if (std::hypot(dx, dy) <= distance) result.set(k % grid.cellsX(), k / grid.cellsX());
      }
    }
    return result;
  }

  BinaryGrid grid;
};

TEST(Proximity, NeverCoversWhatIsBeyondTheLimit)
{
  constexpr int kSide = 18;
  std::mt19937 random(20201024);
  const auto between = [&random](int low, int high) {
    return std::uniform_int_distribution<>(low, high)(random);
  };
  int covered = 0;
  int refused = 0;
  Proximity proximity;
  for (int trial = 0; trial < 150; ++trial) {
    const PlainDistances plain{test::noiseGrid(kSide, kSide, trial % 3 == 0 ? 0.15 : 0.03, random)};
    const double limit = between(1, 6 * kCell) / double{kCell};
    const double reach = limit * between(0, 12) / 10.0;
    const BitGrid occupied = test::bitsOf(plain.grid);
    const BitGrid within = test::bitsOf(plain.cellsWithin(reach));
    proximity.setLimit(limit, limit - reach);
    proximity.setCells(occupied, within);
    for (int n = 0; n < 60; ++n) {
      const int size = (n % 2 == 0 ? 2 : 8) * kCell;
      const LatticePoint a{between(0, kSide * kCell), between(0, kSide * kCell)};
      const auto near = [&](std::int32_t from) {
        return std::clamp(from + between(-size, size), 0, kSide * kCell);
      };
      const LatticePoint b{near(a.x), near(a.y)};
      const LatticePoint c{near(a.x), near(a.y)};
      if (cross(a, b, c) == 0) continue;
      if (!proximity.covers(a, b, c)) {
        ++refused;
        continue;
      }
      ++covered;
      constexpr int kSteps = 12;
      for (int p = 0; p <= kSteps; ++p) {
        for (int q = 0; p + q <= kSteps; ++q) {
          const double u = p / double{kSteps};
          const double v = q / double{kSteps};
          const double x = (a.x + u * (b.x - a.x) + v * (c.x - a.x)) / kCell;
          const double y = (a.y + u * (b.y - a.y) + v * (c.y - a.y)) / kCell;
          ASSERT_LE(plain.toCells(x, y), limit + 1e-9)
              << "of (" << x << ", " << y << ") in " << testing::PrintToString(test::Corners{a, b, c})
              << ", of " << testing::PrintToString(test::textFromGrid(plain.grid));
        }
      }
    }
  }
  EXPECT_GT(covered, 1000);
  EXPECT_GT(refused, 1000);
}

TEST(Proximity, CoversWhatOneCellAccountsFor)
{
  constexpr int kSide = 12;
  std::mt19937 random(3);
  const auto between = [&random](int low, int high) {
    return std::uniform_int_distribution<>(low, high)(random);
  };
  int accounted = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const PlainDistances plain{test::noiseGrid(kSide, kSide, 0.02, random)};
    const double limit = between(0, 5 * kCell) / double{kCell};
    // Triangles of at most 2.4 cells across are small enough to be looked at as a whole.
    const LatticePoint from{between(0, (kSide - 2) * kCell), between(0, (kSide - 2) * kCell)};
    const auto corner = [&] { return LatticePoint{from.x + between(0, 108), from.y + between(0, 108)}; };
    const LatticePoint a = corner();
    const LatticePoint b = corner();
    const LatticePoint c = corner();
    const test::Corners corners = {a, b, c};
    bool by_one_cell = false;
    for (int k = 0; k < kSide * kSide; ++k) {
      if (plain.grid.cells()[static_cast<std::size_t>(k)] == 0) continue;
      by_one_cell |= std::all_of(corners.begin(), corners.end(), [&](LatticePoint p) {
        return PlainDistances::to(k % kSide, k / kSide, p.x / double{kCell}, p.y / double{kCell}) <= limit;
      });
    }
    if (!by_one_cell) continue;
    ++accounted;
    const BitGrid occupied = test::bitsOf(plain.grid);
    BitGrid free;
    free.reset(kSide, kSide);
    Proximity proximity;
    proximity.setLimit(limit, 0.0);
    proximity.setCells(occupied, free);
    ASSERT_TRUE(proximity.covers(a, b, c))
        << testing::PrintToString(test::Corners{a, b, c}) << ", limit " << limit << ", of "
        << testing::PrintToString(test::textFromGrid(plain.grid));
  }
  EXPECT_GT(accounted, 500);
}

}  // namespace
}  // namespace polygonal_perception::occupancy

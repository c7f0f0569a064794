#include <gtest/gtest.h>

#include <algorithm>

#include "occupancy/polygons/outline_reduction.hpp"
#include "support/drawn_outlines.hpp"

namespace polygonal_perception::occupancy {
namespace {

using test::Corners;
using test::cornersOf;
using test::inCells;

constexpr std::int64_t kTwiceACell = std::int64_t{2} * kUnitsPerCell * kUnitsPerCell;

/// Outlines that are about to be reduced, in a grid of which drawn cells are occupied.
class Reduced
{
public:
  Reduced(const std::vector<std::string>& occupied, double limit, const Outlines& drawn)
      : outlines(drawn), occupied_(test::bitsFromText(occupied))
  {
    BitGrid none;
    none.reset(occupied_.cellsX(), occupied_.cellsY());
    proximity_.setLimit(limit, -1.0);
    proximity_.setCells(occupied_, none);
    reduction.start(occupied_.cellsX(), occupied_.cellsY(), proximity_, outlines);
  }
  /// The outlines of the cells themselves.
  Reduced(const std::vector<std::string>& occupied, double limit)
      : Reduced(occupied, limit, test::traced(occupied))
  {
  }

  std::uint32_t vertexAt(LatticePoint point) const
  {
    std::uint32_t v = 0;
    while (outlines.vertices.at(v).next == Outlines::kNone || !(outlines.vertices[v].at == point)) ++v;
    return v;
  }
  std::int64_t costAt(LatticePoint point) const { return reduction.cost(vertexAt(point)); }
  bool removeAt(LatticePoint point)
  {
    std::uint32_t resume = 0;
    return reduction.removeVertex(vertexAt(point), outlines.rings[0], resume);
  }

  Outlines outlines;
  OutlineReduction reduction;

private:
  BitGrid occupied_;
  Proximity proximity_;
};

/// No limit in a grid of a few cells.
constexpr double kFar = 100.0;
const std::vector<std::string> kL = {"#.", "##"};
const LatticePoint kInner{64, 64};

TEST(OutlineReduction, AnInnerCornerCostsItsTriangle)
{
  EXPECT_EQ(Reduced(kL, kFar).costAt(kInner), kTwiceACell / 2);
}

TEST(OutlineReduction, CutsOffAnInnerCorner)
{
  Reduced reduced(kL, kFar);
  const std::uint32_t vertex = reduced.vertexAt(kInner);
  std::uint32_t resume = Outlines::kNone;
  ASSERT_TRUE(reduced.reduction.removeVertex(vertex, reduced.outlines.rings[0], resume));
  EXPECT_EQ(cornersOf(reduced.outlines, 0), inCells({{0, 0}, {2, 0}, {2, 1}, {1, 2}, {0, 2}}));
  EXPECT_EQ(resume, reduced.vertexAt({128, 0})) << "two vertices before the one that is gone";
}

TEST(OutlineReduction, AStraightVertexCostsNothing)
{
  Reduced reduced({"##", "##"}, kFar,
                  test::outlinesThrough({inCells({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}})}));
  EXPECT_EQ(reduced.costAt({64, 0}), 0);
  EXPECT_TRUE(reduced.removeAt({64, 0}));
  EXPECT_EQ(cornersOf(reduced.outlines, 0), inCells({{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
}

TEST(OutlineReduction, AStraightVertexCostsNothingBesideAnInnerCornerToo)
{
  const Corners drawn = {{0, 0}, {128, 0}, {128, 64}, {96, 64}, kInner, {64, 128}, {0, 128}};
  EXPECT_EQ(Reduced(kL, kFar, test::outlinesThrough({drawn})).costAt({96, 64}), 0);
}

TEST(OutlineReduction, CutsNothingOffThatAnotherRingStandsIn)
{
  Reduced alone({"#...", "#...", "#...", "####"}, kFar);
  EXPECT_TRUE(alone.removeAt(kInner));
  Reduced beside({"#...", "#.#.", "#...", "####"}, kFar);
  ASSERT_FALSE(beside.removeAt(kInner));
  EXPECT_EQ(beside.outlines.rings[0].size, 6U);
  EXPECT_EQ(beside.costAt(kInner), OutlineReduction::kNever) << "until something changes beside it";
}

TEST(OutlineReduction, CutsNothingOffBeyondTheLimit)
{
  // The middle of the cut is 1.5 cells away from the nearest ones.
  const std::vector<std::string> wide = {"#...", "#...", "#...", "####"};
  EXPECT_TRUE(Reduced(wide, 1.5).removeAt(kInner));
  EXPECT_FALSE(Reduced(wide, 1.4).removeAt(kInner));
}

/// A square of 3 cells without one corner.
const Corners kBevelled = {{0, 0}, {192, 0}, {192, 128}, {128, 192}, {0, 192}};
const std::vector<std::string> kThree = {"###", "###", "###"};

TEST(OutlineReduction, AnEdgeBetweenOuterCornersCostsWhatItsNeighboursEnclose)
{
  EXPECT_EQ(Reduced(kThree, kFar, test::outlinesThrough({kBevelled})).costAt({192, 128}), 64 * 64);
}

TEST(OutlineReduction, ExtendsTheNeighboursOfAnEdgeUntilTheyMeet)
{
  Reduced reduced(std::vector<std::string>(4, "####"), kFar, test::outlinesThrough({kBevelled}));
  EXPECT_TRUE(reduced.removeAt({192, 128}));
  const Corners square = inCells({{0, 0}, {3, 0}, {3, 3}, {0, 3}});
  EXPECT_EQ(cornersOf(reduced.outlines, 0), square);
  for (const LatticePoint corner : square)
    EXPECT_EQ(reduced.costAt(corner), OutlineReduction::kNever) << testing::PrintToString(corner);
}

TEST(OutlineReduction, NeighboursThatNeverMeetStay)
{
  // Of a square they are parallel, of a trapezoid they part.
  Reduced square(kThree, kFar, test::outlinesThrough({inCells({{0, 0}, {3, 0}, {3, 3}, {0, 3}})}));
  EXPECT_EQ(square.costAt({0, 0}), OutlineReduction::kNever);
  Reduced trapezoid(kThree, kFar, test::outlinesThrough({inCells({{0, 0}, {3, 0}, {2, 3}, {1, 3}})}));
  EXPECT_EQ(trapezoid.costAt({0, 0}), OutlineReduction::kNever);
  EXPECT_NE(trapezoid.costAt({128, 192}), OutlineReduction::kNever) << "at the narrow end they meet";
}

TEST(OutlineReduction, ExtendsNothingBeyondTheGrid)
{
  // The sides beside x = 192 meet in (224, 96).
  const Corners pointed = {{0, 0}, {128, 0}, {192, 64}, {192, 128}, {128, 192}, {0, 192}};
  EXPECT_TRUE(Reduced({"####", "####", "####"}, kFar, test::outlinesThrough({pointed})).removeAt({192, 64}));
  Reduced at_border(kThree, kFar, test::outlinesThrough({pointed}));
  EXPECT_FALSE(at_border.removeAt({192, 64}));
  EXPECT_EQ(cornersOf(at_border.outlines, 0), pointed);
}

TEST(OutlineReduction, RoundsNoMeetingOverTheGridsBorder)
{
  // The sides beside x = 190 meet in (192.5, 64.5).
  const Corners drawn = {{0, 0}, {128, 0}, {190, 62}, {190, 67}, {128, 129}, {0, 129}};
  EXPECT_TRUE(Reduced({"####", "####", "####"}, kFar, test::outlinesThrough({drawn})).removeAt({190, 62}));
  EXPECT_FALSE(Reduced(kThree, kFar, test::outlinesThrough({drawn})).removeAt({190, 62}));
}

TEST(OutlineReduction, ExtendsNothingBeyondTheLimit)
{
  const std::vector<std::string> left = {"#..", "#..", "#.."};
  EXPECT_TRUE(Reduced(left, 2.0, test::outlinesThrough({kBevelled})).removeAt({192, 128}));
  EXPECT_FALSE(Reduced(left, 1.9, test::outlinesThrough({kBevelled})).removeAt({192, 128}));
}

TEST(OutlineReduction, ExtendsNothingIntoAnotherRing)
{
  const Corners beside = {{170, 175}, {190, 175}, {190, 190}, {170, 190}};
  Reduced reduced(kThree, kFar, test::outlinesThrough({kBevelled, beside}));
  EXPECT_FALSE(reduced.removeAt({192, 128}));
  EXPECT_EQ(cornersOf(reduced.outlines, 0), kBevelled);
}

TEST(OutlineReduction, WhereTheMeetingIsOffTheLatticeNoCornerIsLeftOutside)
{
  // Whole coordinates near to where the lines meet: the old corners stay on the inner side.
  for (std::int32_t dx = 1; dx < 40; ++dx) {
    for (std::int32_t dy = 1; dy < 40; ++dy) {
      const Corners drawn = {{0, 0}, {150, 7}, {150 + dx, 60}, {150 - dy, 100}, {7, 150}};
      if (cross(drawn[1], drawn[2], drawn[3]) <= 0 || cross(drawn[2], drawn[3], drawn[4]) <= 0) continue;
      Reduced reduced(std::vector<std::string>(9, "#########"), kFar, test::outlinesThrough({drawn}));
      if (!reduced.removeAt(drawn[2])) continue;
      const Corners corners = cornersOf(reduced.outlines, 0);
      ASSERT_EQ(corners.size(), 4U);
      for (const LatticePoint old : drawn) {
        for (std::size_t n = 0; n < 4; ++n) {
          ASSERT_GE(cross(corners[n], corners[(n + 1) % 4], old), 0)
              << testing::PrintToString(old) << " is outside of " << testing::PrintToString(corners)
              << ", of " << testing::PrintToString(drawn);
        }
      }
    }
  }
}

TEST(OutlineReduction, AStepChangesTheCostsBesideIt)
{
  Reduced reduced(kL, kFar);
  // The ends of the edges beside the inner corner, and those before and behind the bevel that it becomes.
  const Corners beside = {{128, 0}, {128, 64}, {64, 128}};
  for (const LatticePoint corner : beside)
    EXPECT_EQ(reduced.costAt(corner), OutlineReduction::kNever) << testing::PrintToString(corner);
  ASSERT_TRUE(reduced.removeAt(kInner));
  for (const LatticePoint corner : beside)
    EXPECT_EQ(reduced.costAt(corner), 64 * 64) << testing::PrintToString(corner);
  ASSERT_TRUE(reduced.removeAt(beside[1]));
  EXPECT_EQ(cornersOf(reduced.outlines, 0), inCells({{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
}

const std::vector<std::string> kFrame = {"###", "#.#", "###"};

TEST(OutlineReduction, FillsAHoleThatCostsNoMoreThanItsVerticesAreWorth)
{
  // A cell for four vertices.
  Reduced reduced(kFrame, kFar);
  EXPECT_FALSE(reduced.reduction.fillHole(reduced.outlines.rings[1], kTwiceACell / 4 - 1));
  EXPECT_EQ(reduced.outlines.rings[1].size, 4U);
  EXPECT_TRUE(reduced.reduction.fillHole(reduced.outlines.rings[1], kTwiceACell / 4));
  EXPECT_EQ(reduced.outlines.rings[1].size, 0U);
  EXPECT_EQ(cornersOf(reduced.outlines, 0), inCells({{0, 0}, {3, 0}, {3, 3}, {0, 3}}));
}

TEST(OutlineReduction, FillsNoHoleBeyondTheLimit)
{
  // Its middle is 1.5 cells away from the nearest ones.
  const std::vector<std::string> wide = {"#####", "#...#", "#...#", "#...#", "#####"};
  Reduced near(wide, 1.4);
  EXPECT_FALSE(near.reduction.fillHole(near.outlines.rings[1], 100 * kTwiceACell));
  EXPECT_EQ(near.outlines.rings[1].size, 4U);
  Reduced far(wide, 2.5);
  EXPECT_TRUE(far.reduction.fillHole(far.outlines.rings[1], 100 * kTwiceACell));
}

}  // namespace
}  // namespace polygonal_perception::occupancy

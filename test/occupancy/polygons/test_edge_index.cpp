#include <gtest/gtest.h>

#include "occupancy/polygons/edge_index.hpp"
#include "support/drawn_outlines.hpp"

namespace polygonal_perception::occupancy {
namespace {

using test::Corners;
using test::outlinesThrough;

constexpr std::int32_t kClearance = EdgeIndex::kClearance;
constexpr int kCells = 40;
constexpr std::int32_t kBucket = 8 * kUnitsPerCell;

/// A block with a notch in its upper side, which lies in y = 100 from (200, 100) to (0, 100).
const Corners kNotched = {{0, 0}, {200, 0}, {200, 100}, {100, 50}, {0, 100}};

/// What filling the notch adds.
EdgeIndex::Change fillingTheNotch()
{
  EdgeIndex::Change change;
  change.first = 2;
  change.last = 4;
  change.add(kNotched[2], kNotched[3], kNotched[4]);
  return change;
}

bool isClear(const EdgeIndex::Change& change, const Outlines& outlines)
{
  EdgeIndex index;
  index.build(kCells, kCells, outlines);
  return index.isClear(change, outlines);
}

/// Can the notch be filled beside another ring?
bool canFillBeside(const Corners& other)
{
  return isClear(fillingTheNotch(), outlinesThrough({kNotched, other}));
}

TEST(EdgeIndex, TheChainAndItsNeighboursAreNotInTheWay)
{
  EXPECT_TRUE(isClear(fillingTheNotch(), outlinesThrough({kNotched})));
}

TEST(EdgeIndex, AnEdgeKeepsTheClearance)
{
  const auto above = [](std::int32_t y) { return Corners{{20, y}, {80, y}, {80, y + 50}, {20, y + 50}}; };
  EXPECT_TRUE(canFillBeside(above(100 + kClearance)));
  EXPECT_FALSE(canFillBeside(above(100 + kClearance - 1)));
}

TEST(EdgeIndex, ACornerKeepsTheClearance)
{
  const auto tip = [](std::int32_t y) { return Corners{{100, y}, {130, y + 50}, {70, y + 50}}; };
  EXPECT_TRUE(canFillBeside(tip(100 + kClearance)));
  EXPECT_FALSE(canFillBeside(tip(100 + kClearance - 1)));
}

TEST(EdgeIndex, ACornerOfTheChangeKeepsTheClearanceFromAnEdge)
{
  // The edge x = 300 stands beside a triangle that points at it.
  const auto toPoint = [](std::int32_t x) {
    EdgeIndex::Change change;
    change.first = 2;
    change.last = 4;
    change.add({220, 150}, {220, 50}, {x, 100});
    return isClear(change, outlinesThrough({kNotched, {{300, 0}, {400, 0}, {400, 300}, {300, 300}}}));
  };
  EXPECT_TRUE(toPoint(300 - kClearance));
  EXPECT_FALSE(toPoint(300 - kClearance + 1));
}

TEST(EdgeIndex, WhatStandsInTheNotchIsInTheWay)
{
  EXPECT_FALSE(canFillBeside({{95, 80}, {105, 80}, {105, 90}, {95, 90}})) << "all of it";
  EXPECT_FALSE(canFillBeside({{95, 80}, {105, 80}, {105, 300}, {95, 300}})) << "an end of it";
  EXPECT_FALSE(canFillBeside({{-20, 90}, {300, 90}, {300, 95}, {-20, 95}})) << "what runs through";
}

/// An open path, so that no other edge is in the way, of which the notch is the chain: (200, 100), (100, 50),
/// (0, 100). What comes before and behind it varies.
Outlines pathThroughTheNotch(LatticePoint before, LatticePoint behind)
{
  Outlines outlines = outlinesThrough({{{0, 400}, before, kNotched[2], kNotched[3], kNotched[4], behind}});
  outlines.vertices[0].next = Outlines::kNone;
  outlines.vertices[5].next = Outlines::kNone;
  return outlines;
}

TEST(EdgeIndex, NeighboursMayFanOut)
{
  const EdgeIndex::Change change = fillingTheNotch();
  EXPECT_TRUE(isClear(change, pathThroughTheNotch({300, 100}, {0, 300})));
  EXPECT_TRUE(isClear(change, pathThroughTheNotch({200, 300}, {0, 0})));
}

TEST(EdgeIndex, NeighboursMayNotRunIn)
{
  const EdgeIndex::Change change = fillingTheNotch();
  EXPECT_FALSE(isClear(change, pathThroughTheNotch({300, 100}, {100, 80}))) << "the one behind";
  EXPECT_FALSE(isClear(change, pathThroughTheNotch({100, 80}, {0, 300}))) << "the one before";
  EXPECT_FALSE(isClear(change, pathThroughTheNotch({300, 100}, {300, 60}))) << "and through";
}

TEST(EdgeIndex, NeighboursKeepTheClearanceAtTheirFarEnd)
{
  const EdgeIndex::Change change = fillingTheNotch();
  EXPECT_TRUE(isClear(change, pathThroughTheNotch({300, 100}, {150, 100 + kClearance})));
  EXPECT_FALSE(isClear(change, pathThroughTheNotch({300, 100}, {150, 100 + kClearance - 1})));
  EXPECT_TRUE(isClear(change, pathThroughTheNotch({50, 100 + kClearance}, {0, 300})));
  EXPECT_FALSE(isClear(change, pathThroughTheNotch({50, 100 + kClearance - 1}, {0, 300})));
}

TEST(EdgeIndex, NeighboursKeepTheClearanceFromTheFarCorner)
{
  // They pass (200, 100) or (0, 100) on the way.
  const EdgeIndex::Change change = fillingTheNotch();
  EXPECT_TRUE(isClear(change, pathThroughTheNotch({200, 300}, {400, 110})));
  EXPECT_FALSE(isClear(change, pathThroughTheNotch({200, 300}, {400, 106})));
  EXPECT_TRUE(isClear(change, pathThroughTheNotch({-200, 110}, {0, 300})));
  EXPECT_FALSE(isClear(change, pathThroughTheNotch({-200, 106}, {0, 300})));
}

TEST(EdgeIndex, ATriangleAwayFromTheChainKeepsOffItsNeighbours)
{
  // Extending two neighbours adds triangles of which some touch the chain's ends, some do not.
  const auto withTriangleAt = [](std::int32_t y) {
    EdgeIndex::Change change = fillingTheNotch();
    change.add({150, y}, {160, y}, {150, y + 10});
    return isClear(change, pathThroughTheNotch({300, 100}, {300, 150}));
  };
  EXPECT_TRUE(withTriangleAt(200));
  EXPECT_FALSE(withTriangleAt(124));
}

TEST(EdgeIndex, AChangeTakesInTrianglesCounterClockwise)
{
  EdgeIndex::Change change;
  change.add({0, 0}, {10, 0}, {0, 10});
  change.add({0, 0}, {0, 10}, {10, 0});
  change.add({0, 0}, {5, 5}, {10, 10});
  ASSERT_EQ(change.triangle_count, 2U) << "the last one has no area";
  for (std::size_t n = 0; n < 2; ++n)
    EXPECT_GT(cross(change.triangles[n][0], change.triangles[n][1], change.triangles[n][2]), 0);
}

TEST(EdgeIndex, ForgetsAnEdgeThatHasLeftItsRing)
{
  // A spike into the notch, which is cut off later.
  Outlines outlines = outlinesThrough({kNotched, {{0, 200}, {100, 80}, {200, 200}, {100, 300}}});
  EdgeIndex index;
  index.build(kCells, kCells, outlines);
  EXPECT_FALSE(index.isClear(fillingTheNotch(), outlines));
  outlines.remove(6, outlines.rings[1]);
  index.add(5, outlines);
  EXPECT_TRUE(index.isClear(fillingTheNotch(), outlines));
  EXPECT_TRUE(index.isClear(fillingTheNotch(), outlines)) << "still";
}

TEST(EdgeIndex, ForgetsNoOtherEdgeWithIt)
{
  const Corners stays = {{95, 80}, {105, 80}, {105, 90}};
  Outlines outlines = outlinesThrough({kNotched, stays, {{0, 200}, {100, 150}, {200, 200}, {100, 300}}});
  EdgeIndex index;
  index.build(kCells, kCells, outlines);
  outlines.remove(9, outlines.rings[2]);
  EXPECT_FALSE(index.isClear(fillingTheNotch(), outlines));
  EXPECT_FALSE(index.isClear(fillingTheNotch(), outlines)) << "still";
}

TEST(EdgeIndex, KnowsAnEdgeThatWasAdded)
{
  // Cut off at its upper corner the ring comes down into the notch.
  Outlines outlines = outlinesThrough({kNotched, {{150, 60}, {300, 300}, {100, 300}, {100, 60}}});
  outlines.vertices[5 + 3].next = Outlines::kNone;
  outlines.vertices[5 + 0].next = Outlines::kNone;
  EdgeIndex index;
  index.build(kCells, kCells, outlines);
  ASSERT_FALSE(index.isClear(fillingTheNotch(), outlines)) << "(100, 300) to (100, 60)";
  outlines.vertices[5 + 2].next = Outlines::kNone;
  ASSERT_TRUE(index.isClear(fillingTheNotch(), outlines));
  outlines.vertices[5 + 3].next = 5;
  index.add(5 + 3, outlines);
  EXPECT_FALSE(index.isClear(fillingTheNotch(), outlines));
}

/// A small triangle, to be put anywhere.
EdgeIndex::Change triangleAt(std::int32_t x, std::int32_t y)
{
  EdgeIndex::Change change;
  change.first = 2;
  change.last = 4;
  change.add({x, y}, {x + 20, y}, {x, y + 20});
  return change;
}

TEST(EdgeIndex, FindsAnEdgeInEveryBucketThatItPasses)
{
  const Outlines outlines =
      outlinesThrough({kNotched, {{10, 300}, {4 * kBucket, 300 + 2 * kBucket}, {10, 310 + 2 * kBucket}}});
  for (std::int32_t x = 20; x < 4 * kBucket - 20; x += 100) {
    const std::int32_t y = 300 + x / 2;
    EXPECT_FALSE(isClear(triangleAt(x, y - 10), outlines)) << "at x = " << x;
    EXPECT_TRUE(isClear(triangleAt(x, y - 60), outlines)) << "at x = " << x;
  }
}

TEST(EdgeIndex, FindsAnEdgeInEveryBucketOfAChange)
{
  EdgeIndex::Change change;
  change.first = 2;
  change.last = 4;
  change.add({300, 300}, {300 + 4 * kBucket, 300}, {300, 300 + 4 * kBucket});
  for (std::int32_t offset = 0; offset < 2 * kBucket; offset += 150) {
    const std::int32_t x = 400 + offset;
    const Corners inside = {{x, x}, {x + 30, x}, {x + 30, x + 30}};
    const Corners outside = {{x + 2300, x}, {x + 2330, x}, {x + 2330, x + 30}};
    EXPECT_EQ(isClear(change, outlinesThrough({kNotched, inside})), x > 300 + 2 * kBucket) << "at " << x;
    EXPECT_TRUE(isClear(change, outlinesThrough({kNotched, outside}))) << "at " << x;
  }
}

TEST(EdgeIndex, FindsEdgesJustOverTheBordersOfBuckets)
{
  // The triangle and the edge lie in different buckets, nearer than the clearance.
  for (const std::int32_t border : {kBucket, 2 * kBucket}) {
    const Corners right = {{border, 300}, {border + 50, 300}, {border + 50, 400}, {border, 400}};
    const Corners above = {{300, border}, {400, border}, {400, border + 50}, {300, border + 50}};
    EXPECT_FALSE(isClear(triangleAt(border - 20 - kClearance + 1, 340), outlinesThrough({kNotched, right})));
    EXPECT_FALSE(isClear(triangleAt(340, border - 20 - kClearance + 1), outlinesThrough({kNotched, above})));
  }
}

TEST(EdgeIndex, KnowsTheGridsBorder)
{
  // A grid of whole buckets: its far sides lie where the next bucket would begin.
  constexpr std::int32_t kEnd = kCells * kUnitsPerCell;
  static_assert(kEnd % kBucket == 0, "the far side begins a bucket");
  const Outlines outlines = outlinesThrough({kNotched,
                                             {{kEnd - 300, 750}, {kEnd, 500}, {kEnd, 1000}},
                                             {{500, kEnd}, {750, kEnd - 300}, {1000, kEnd}}});
  EXPECT_FALSE(isClear(triangleAt(kEnd - 22, 750), outlines));
  EXPECT_FALSE(isClear(triangleAt(750, kEnd - 22), outlines));
  EXPECT_FALSE(isClear(triangleAt(0, 0), outlines)) << "the block's own corner";
}

TEST(EdgeIndex, BuildForgetsWhatWasThere)
{
  EdgeIndex index;
  index.build(kCells, kCells, outlinesThrough({kNotched, {{95, 80}, {105, 80}, {105, 90}, {95, 90}}}));
  const Outlines alone = outlinesThrough({kNotched});
  index.build(kCells, kCells, alone);
  EXPECT_TRUE(index.isClear(fillingTheNotch(), alone));
}

}  // namespace
}  // namespace polygonal_perception::occupancy

#include <gtest/gtest.h>

#include "occupancy/polygons/staircase_bridging.hpp"
#include "support/drawn_outlines.hpp"

namespace polygonal_perception::occupancy {
namespace {

using test::Corners;
using test::cornersOf;
using test::inCells;

void bridge(const std::vector<std::string>& cells, double limit, Outlines& outlines)
{
  const BitGrid bits = test::bitsFromText(cells);
  Proximity proximity;
  proximity.setLimit(limit, 0.0);
  proximity.setCells(bits, bits);
  StaircaseBridging().bridge(bits, proximity, outlines);
}

/// The outlines of cells, bridged.
Outlines bridged(const std::vector<std::string>& cells, double limit = 3.0)
{
  Outlines outlines = test::traced(cells);
  bridge(cells, limit, outlines);
  return outlines;
}

bool isLeftAlone(const std::vector<std::string>& cells, double limit = 3.0)
{
  return test::verticesOf(bridged(cells, limit)) == test::verticesOf(test::traced(cells));
}

TEST(StaircaseBridging, StepsOfOneCellBecomeALine)
{
  EXPECT_EQ(cornersOf(bridged({"#...", "##..", "###.", "####"}), 0),
            inCells({{0, 0}, {4, 0}, {4, 1}, {3, 2}, {2, 3}, {1, 4}, {0, 4}}));
}

TEST(StaircaseBridging, InEveryDirection)
{
  EXPECT_EQ(cornersOf(bridged({".#.", "###", ".#."}), 0),
            inCells({{1, 0}, {2, 0}, {3, 1}, {3, 2}, {2, 3}, {1, 3}, {0, 2}, {0, 1}}));
}

TEST(StaircaseBridging, AStepMayBeTwoCellsLongAndNoLonger)
{
  EXPECT_EQ(cornersOf(bridged({"#..", "###"}), 0), inCells({{0, 0}, {3, 0}, {3, 1}, {1, 2}, {0, 2}}));
  EXPECT_EQ(cornersOf(bridged({"#.", "#.", "##"}), 0), inCells({{0, 0}, {2, 0}, {2, 1}, {1, 3}, {0, 3}}));
  EXPECT_TRUE(isLeftAlone({"#...", "####"}));
  EXPECT_TRUE(isLeftAlone({"#..", "#..", "###"})) << "two by two";
}

TEST(StaircaseBridging, LeavesRoomForWhatStandsBehind)
{
  EXPECT_TRUE(isLeftAlone({"..#", "#..", "##."}));
  EXPECT_FALSE(isLeftAlone({"...#", "#...", "##.."})) << "a cell farther";
}

TEST(StaircaseBridging, ANookWithSomethingAcrossIsNone)
{
  // The far end of a hole's step leads along another cell.
  EXPECT_TRUE(isLeftAlone({"###", "#.#", "###"}));
  EXPECT_TRUE(isLeftAlone({"####", "#..#", "####"}));
}

TEST(StaircaseBridging, BridgesInHolesToo)
{
  const std::vector<std::string> cells = {"#######", "#.....#", "#.....#", "##....#", "###...#", "#######"};
  const Outlines outlines = bridged(cells);
  EXPECT_EQ(cornersOf(outlines, 1), inCells({{3, 1}, {3, 2}, {2, 3}, {1, 3}, {1, 5}, {6, 5}, {6, 1}}));
}

TEST(StaircaseBridging, GoesNotBeyondTheLimit)
{
  // The bridge's ends are a cell's side away from the nearest cell that accounts for both.
  const std::vector<std::string> covered = {"#.", "##"};
  EXPECT_FALSE(isLeftAlone(covered, 1.0));
  EXPECT_TRUE(isLeftAlone(covered, 0.9));
}

TEST(StaircaseBridging, LeavesCornersThatGaveWay)
{
  EXPECT_TRUE(isLeftAlone({"#.", ".#"}));
  EXPECT_TRUE(isLeftAlone({".#", "#."}));
}

TEST(StaircaseBridging, ARingMayStartAtACornerThatGoes)
{
  const std::vector<std::string> cells = {"#.", "##"};
  Outlines outlines = test::traced(cells);
  std::uint32_t& start = outlines.rings[0].start;
  while (!(outlines.vertices[start].at == LatticePoint{64, 64})) start = outlines.vertices[start].next;
  bridge(cells, 3.0, outlines);
  EXPECT_EQ(cornersOf(outlines, 0), inCells({{1, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 1}}));
}

}  // namespace
}  // namespace polygonal_perception::occupancy

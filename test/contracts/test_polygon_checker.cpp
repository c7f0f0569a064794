#include <gtest/gtest.h>

#include <utility>

#include "reference/polygon_checker.hpp"

namespace polygonal_perception::test {
namespace {

using Corners = std::vector<std::pair<double, double>>;

/// A grid of 9 x 9 cells of 1 m whose middle cell, from (4, 4) to (5, 5), is occupied, and rings about it.
/// The radius is one cell, the limit three.
class PolygonCheckerTest : public ::testing::Test
{
protected:
  PolygonCheckerTest()
  {
    occupancy::GridGeometry geometry;
    geometry.cells_x = 9;
    geometry.cells_y = 9;
    geometry.resolution = 1.0;
    grid_.reset(geometry);
    grid_.set(4, 4);
  }

  void add(const Corners& corners, bool hole = false)
  {
    polygons_.rings.push_back({static_cast<std::uint32_t>(polygons_.vertices.size()),
                               static_cast<std::uint32_t>(corners.size()), hole});
    for (const auto& [x, y] : corners) polygons_.vertices.emplace_back(x, y);
  }

  void expectFault(const std::string& beginning) const
  {
    const auto fault = reference::PolygonChecker(grid_, polygons_, {1, 1}, {3, 1}).fault();
    ASSERT_TRUE(fault) << "nothing found, expected: " << beginning;
    EXPECT_EQ(fault->substr(0, beginning.size()), beginning) << *fault;
  }

  static Corners square(double low, double high)
  {
    return {{low, low}, {high, low}, {high, high}, {low, high}};
  }

  occupancy::BinaryGrid grid_;
  geometry::PolygonSet polygons_;
};

TEST_F(PolygonCheckerTest, PassesASquareThatIsLargeEnough)
{
  add(square(3, 6));
  EXPECT_FALSE(reference::PolygonChecker(grid_, polygons_, {1, 1}, {3, 1}).fault());
}

TEST_F(PolygonCheckerTest, FindsAnEdgeThatIsA64thOfACellTooNear)
{
  add(square(3 + 1.0 / 64, 6));
  expectFault("clause 3: the edge");
}

TEST_F(PolygonCheckerTest, FindsACornerCutTooNear)
{
  // The cut passes the cell's corner (5, 5) at 1 / sqrt(2) of a cell.
  add({{3, 3}, {6, 3}, {6, 5}, {5, 6}, {3, 6}});
  expectFault("clause 3: the edge");
}

TEST_F(PolygonCheckerTest, FindsAnObstacleWithoutPolygon)
{
  expectFault("clause 3: the occupied cell");
}

TEST_F(PolygonCheckerTest, FindsAnEdgeThatIsA64thOfACellTooFar)
{
  add({{1 - 1.0 / 64, 4.5}, {3, 3}, {6, 3}, {6, 6}, {3, 6}});
  expectFault("clause 4: the edge");
}

TEST_F(PolygonCheckerTest, FindsAPointInsideThatIsTooFar)
{
  // A ring of occupied cells along the grid's border: everywhere near them, but not in the middle of the
  // polygon.
  for (int k = 0; k < 9; ++k) {
    for (const auto& [i, j] : {std::pair(k, 0), std::pair(k, 8), std::pair(0, k), std::pair(8, k)})
      grid_.set(i, j);
  }
  grid_.set(4, 4, false);
  add(square(0, 9));
  expectFault("clause 4: a point inside");
}

TEST_F(PolygonCheckerTest, FindsABowTie)
{
  add({{3, 3}, {6, 6}, {6, 3}, {3, 6}});
  expectFault("clause 1: a ring touches itself");
}

TEST_F(PolygonCheckerTest, FindsARingThatFoldsBack)
{
  add({{3, 3}, {6, 3}, {6, 7}, {6, 6}, {3, 6}});
  expectFault("clause 1: a ring folds back");
}

TEST_F(PolygonCheckerTest, FindsTooFewVertices)
{
  add({{3, 3}, {6, 6}});
  expectFault("clause 1: a ring of 2");
}

TEST_F(PolygonCheckerTest, FindsAClockwiseBoundary)
{
  add({{3, 6}, {6, 6}, {6, 3}, {3, 3}});
  expectFault("clause 1: wrong orientation");
}

TEST_F(PolygonCheckerTest, FindsAHoleOutside)
{
  add(square(3, 6));
  add({{7, 8}, {8, 8}, {8, 7}, {7, 7}}, true);
  expectFault("clause 1: a hole is outside");
}

TEST_F(PolygonCheckerTest, FindsPolygonsThatTouch)
{
  add(square(3, 6));
  add({{6, 3}, {7, 3}, {7, 4}, {6, 4}});
  expectFault("clause 2: rings touch");
}

TEST_F(PolygonCheckerTest, FindsAPolygonInAnother)
{
  add(square(2, 7));
  add(square(3, 6));
  expectFault("clause 2: polygons overlap");
}

TEST_F(PolygonCheckerTest, FindsAVertexOffTheLattice)
{
  add({{3, 3}, {6.001, 3}, {6, 6}, {3, 6}});
  expectFault("a vertex is not on the lattice");
}

}  // namespace
}  // namespace polygonal_perception::test

#include <gtest/gtest.h>

#include <algorithm>

#include "polygonal_perception/planning/path_search.hpp"

namespace polygonal_perception::planning {
namespace {

using geometry::PolygonSet;
using Ring = std::vector<Eigen::Vector2d>;
using Path = std::vector<Eigen::Vector2d>;

Ring box(double left, double bottom, double right, double top)
{
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

Ring reversed(Ring ring)
{
  std::reverse(ring.begin(), ring.end());
  return ring;
}

class PathSearchTest : public testing::Test
{
protected:
  void setBoundaries(const std::vector<Ring>& boundaries)
  {
    PolygonSet set;
    for (const Ring& ring : boundaries) set.append(ring, false);
    setObstacles(set);
  }
  void setObstacles(const PolygonSet& set)
  {
    const auto fault = space_.build(set);
    ASSERT_FALSE(fault) << fault->text;
    search_.setSpace(space_);
  }
  /// Empty where there is no way.
  Path plan(const Eigen::Vector2d& start, const Eigen::Vector2d& goal)
  {
    Path path;
    const auto from = space_.locate(start);
    const auto to = space_.locate(goal);
    if (!from || !to) {
      ADD_FAILURE() << "an end is blocked";
      return path;
    }
    const auto length = search_.plan(*from, *to, path);
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) sum += (path[i + 1] - path[i]).norm();
    if (length) {
      EXPECT_NEAR(*length, sum, 1e-12);
    } else {
      EXPECT_TRUE(path.empty());
    }
    return path;
  }

  FreeSpace space_;
  PathSearch search_;
};

TEST_F(PathSearchTest, IsStraightWhereNothingStands)
{
  setBoundaries({});
  EXPECT_EQ(plan({0, 0}, {3, 4}), (Path{{0, 0}, {3, 4}}));
}

TEST_F(PathSearchTest, AGoalThatIsTheStart)
{
  setBoundaries({box(0, 0, 1, 1)});
  EXPECT_EQ(plan({2, 2}, {2, 2}), (Path{{2, 2}, {2, 2}}));
}

TEST_F(PathSearchTest, GoesAroundTheNearerSide)
{
  setBoundaries({box(1, -1, 2, 3)});
  EXPECT_EQ(plan({0, 0}, {3, 0}), (Path{{0, 0}, {1, -1}, {2, -1}, {3, 0}}));
}

TEST_F(PathSearchTest, MayTouchAndRunAlong)
{
  setBoundaries({box(1, -1, 2, 0), box(4, 0, 5, 1)});
  const Path path = plan({0, 0}, {6, 0});
  EXPECT_EQ(path.front(), Eigen::Vector2d(0, 0));
  EXPECT_EQ(path.back(), Eigen::Vector2d(6, 0));
  for (const Eigen::Vector2d& point : path) EXPECT_EQ(point.y(), 0.0);
}

TEST_F(PathSearchTest, LeadsThroughNoPointInWhichObstaclesTouch)
{
  setBoundaries({box(-10, 0, 0, 1), box(0, 1, 10, 2)});
  const Path path = plan({1, 0}, {-1, 2});
  ASSERT_GT(path.size(), 2U);
  EXPECT_EQ(std::count(path.begin(), path.end(), Eigen::Vector2d(0, 1)), 0);
}

TEST_F(PathSearchTest, EndsOnBordersAndCorners)
{
  setBoundaries({box(0, 0, 2, 2)});
  EXPECT_EQ(plan({0, 0}, {2, 2}).size(), 3U);
  EXPECT_EQ(plan({0, 0}, {2, 0}), (Path{{0, 0}, {2, 0}})) << "along the edge";
  EXPECT_EQ(plan({0.5, 0}, {1.5, 2}).size(), 4U) << "from one side to the other";
}

TEST_F(PathSearchTest, InAHoleThereIsAWayInsideAndNoneOut)
{
  PolygonSet set;
  set.append(box(0, 0, 10, 10), false);
  set.append(reversed(box(1, 1, 9, 9)), true);
  set.append(box(4, 1.5, 5, 8), false);
  setObstacles(set);
  EXPECT_EQ(plan({2, 2}, {8, 2}), (Path{{2, 2}, {4, 1.5}, {5, 1.5}, {8, 2}}));
  EXPECT_TRUE(plan({2, 2}, {12, 2}).empty());
  EXPECT_TRUE(plan({12, 2}, {2, 2}).empty());
}

TEST_F(PathSearchTest, FindsTheOnlyWayThroughAGap)
{
  setBoundaries(
      {box(0, 0, 1, 10), box(0, 10.001, 1, 20), box(-5, -1, 1, 0), box(-5, 20, 1, 21), box(-5, -1, -4, 21)});
  const Path path = plan({-1, 5}, {3, 5});
  EXPECT_EQ(path.size(), 4U);
  EXPECT_EQ(path[1], Eigen::Vector2d(0, 10));
}

TEST_F(PathSearchTest, MakesLittleOfTheVisibilityGraph)
{
  std::vector<Ring> boxes;
  for (int x = 0; x < 20; ++x)
    for (int y = 0; y < 20; ++y) boxes.push_back(box(2 * x, 2 * y, 2 * x + 1, 2 * y + 1));
  setBoundaries(boxes);
  ASSERT_FALSE(plan({1.5, 20.5}, {20.5, 21.5}).empty());
  std::vector<PathSearch::SeenEdge> edges;
  search_.seenEdges(edges);
  EXPECT_FALSE(edges.empty());
  EXPECT_LT(search_.expandedCorners(), 200U) << "of 1600";
}

}  // namespace
}  // namespace polygonal_perception::planning

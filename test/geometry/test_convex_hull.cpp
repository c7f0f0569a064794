#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "polygonal_perception/geometry/convex_hull.hpp"
#include "polygonal_perception/geometry/predicates.hpp"
#include "polygonal_perception/geometry/ring_view.hpp"

namespace polygonal_perception::geometry {
namespace {

using Points = std::vector<Eigen::Vector2d>;

TEST(ConvexHull, LeavesOutWhatIsInsideOrOnAnEdge)
{
  EXPECT_EQ(convexHull({{2, 2}, {0, 0}, {1, 1}, {2, 0}, {1, 0}, {0, 2}, {0, 1}, {2, 2}}),
            (Points{{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
}

TEST(ConvexHull, OfFewPointsOrPointsOnALine)
{
  EXPECT_EQ(convexHull({}), Points{});
  EXPECT_EQ(convexHull({{1, 2}}), (Points{{1, 2}}));
  EXPECT_EQ(convexHull({{1, 2}, {1, 2}}), (Points{{1, 2}}));
  EXPECT_EQ(convexHull({{3, 4}, {1, 2}}), (Points{{1, 2}, {3, 4}}));
  EXPECT_EQ(convexHull({{3, 3}, {1, 1}, {2, 2}, {0, 0}, {2, 2}}), (Points{{0, 0}, {3, 3}}));
  EXPECT_EQ(convexHull({{1, 3}, {1, 1}, {1, 2}}), (Points{{1, 1}, {1, 3}})) << "upright";
}

TEST(ConvexHull, AnUlpMakesACorner)
{
  EXPECT_EQ(convexHull({{0, 0}, {1.5, 0.5}, {3, 1}, {0, 3}}), (Points{{0, 0}, {3, 1}, {0, 3}}));
  const Eigen::Vector2d below(1.5, 0.5 - 0x1p-54);
  EXPECT_EQ(convexHull({{0, 0}, below, {3, 1}, {0, 3}}), (Points{{0, 0}, below, {3, 1}, {0, 3}}));
}

/// Strictly convex, made of the points, with no point outside.
void expectHull(const Points& points)
{
  const Points hull = convexHull(points);
  ASSERT_GE(hull.size(), 3U);
  const RingView ring(hull);
  for (std::size_t k = 0; k < ring.size(); ++k) {
    ASSERT_NE(std::find(points.begin(), points.end(), ring[k]), points.end()) << ring[k].transpose();
    ASSERT_EQ(orientation(ring[ring.previous(k)], ring[k], ring[ring.next(k)]),
              Orientation::kCounterClockwise)
        << "at " << ring[k].transpose();
  }
  for (const auto [from, to] : ring.edges()) {
    for (const Eigen::Vector2d& p : points)
      ASSERT_NE(orientation(from, to, p), Orientation::kClockwise) << p.transpose() << " is outside";
  }
}

TEST(ConvexHull, OfRandomPoints)
{
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  for (int round = 0; round < 100; ++round) {
    Points points(50);
    for (Eigen::Vector2d& p : points) p = {normal(random), normal(random)};
    expectHull(points);
  }
}

TEST(ConvexHull, OfPointsThatAreNearlyOnALineFarAway)
{
  std::mt19937 random(12);
  std::uniform_int_distribution<int> ulps(-2, 2);
  for (int round = 0; round < 100; ++round) {
    Points points = {{1000.0, 1000.0}};
    for (int k = 1; k < 40; ++k)
      points.emplace_back(1000.0 + k / 64.0 + ulps(random) * 0x1p-43,
                          1000.0 + k / 64.0 + ulps(random) * 0x1p-43);
    points.emplace_back(1000.0, 1001.0);
    expectHull(points);
  }
}

}  // namespace
}  // namespace polygonal_perception::geometry

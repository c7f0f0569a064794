#include <gtest/gtest.h>

#include <cmath>

#include "polygonal_perception/planning/arc_contact.hpp"

namespace polygonal_perception::planning {
namespace {

constexpr double kClose = 1e-8;  // [s] a nanometre at these speeds

/// From (1, 1) down to (1, -1): the obstacle lies at higher x.
MovingEdge wall(const Eigen::Vector2d& velocity = Eigen::Vector2d::Zero(), double growth = 0.0)
{
  return {{1.0, 1.0}, {0.0, -1.0}, 2.0, velocity, growth};
}

double timeOf(const Twist& twist, const MovingEdge& edge, double until = 10.0, const Pose& start = {})
{
  return firstContact(Arc(start, twist), edge, 0.0, until).value_or(-1.0);
}

TEST(ArcContact, StraightAhead)
{
  EXPECT_NEAR(timeOf({0.5, 0.0, 0.0}, wall()), 2.0, kClose);
  EXPECT_EQ(timeOf({-0.5, 0.0, 0.0}, wall()), -1.0) << "away from it";
  EXPECT_EQ(timeOf({0.5, 0.0, 0.0}, wall(), 1.9), -1.0) << "not yet";
  EXPECT_EQ(timeOf({0.0, 0.5, 0.0}, wall()), -1.0) << "past it";
  EXPECT_NEAR(timeOf({0.4, 0.3, 0.0}, wall()), 2.5, kClose) << "sideways, too";
  EXPECT_EQ(timeOf({0.4, 0.42, 0.0}, wall()), -1.0) << "beside its end";
}

TEST(ArcContact, AlongACircle)
{
  // Of radius 2 around (0, 2): at x = 1 after a twelfth of a turn.
  EXPECT_NEAR(timeOf({1.0, 0.0, 0.5}, wall()), M_PI / 3.0, kClose);
  // Of radius 1 around (0, 1): it only touches the line, at the edge's end.
  EXPECT_EQ(timeOf({1.0, 0.0, 1.0}, wall()), -1.0);
  // The first of two crossings that is on the edge, after more than half a turn: around (0.8, 0) from (0, 0).
  const Pose down{{0.0, 0.0}, -M_PI / 2.0};
  EXPECT_NEAR(timeOf({0.8, 0.0, 1.0}, wall(), 10.0, down), M_PI - std::acos(0.25), kClose);
}

TEST(ArcContact, OutOfAnObstacleIsNoContact)
{
  const Pose inside{{1.5, 0.0}, M_PI};
  EXPECT_EQ(timeOf({0.5, 0.0, 0.0}, wall(), 10.0, inside), -1.0);
  // In a circle of radius 1 around (1.5, -1): out by the line, back in through the edge's line below its end.
  EXPECT_EQ(timeOf({1.0, 0.0, 1.0}, wall(), 10.0, inside), -1.0);
}

TEST(ArcContact, TouchingAtTheStart)
{
  const Pose at{{1.0, 0.0}, 0.0};
  EXPECT_NEAR(timeOf({0.5, 0.0, 0.0}, wall(), 10.0, at), 0.0, kClose);
  EXPECT_EQ(timeOf({0.0, 0.5, 0.0}, wall(), 10.0, at), -1.0) << "along it";
  EXPECT_EQ(timeOf({-0.5, 0.0, 0.0}, wall(), 10.0, at), -1.0) << "away from it";
  EXPECT_EQ(timeOf({0.0, 0.0, 1.0}, wall(), 10.0, at), -1.0) << "turning on the spot";
  const Arc deeper(Pose{{1.0001, 0.0}, 0.0}, {0.5, 0.0, 0.0});
  EXPECT_NEAR(firstContact(deeper, wall(), 0.0, 1.0, 1.0001 - 1.0).value_or(-1.0), 0.0, kClose)
      << "no deeper than it is";
  EXPECT_FALSE(firstContact(Arc(Pose{{1.0001, 0.0}, 0.0}, {-0.5, 0.0, 0.0}), wall(), 0.0, 1.0, 1.0001 - 1.0));
}

TEST(ArcContact, ThroughAVertexIsThroughOneOfItsEdges)
{
  EXPECT_GT(timeOf({1.0, 1.0, 0.0}, wall()), 0.99);
  EXPECT_GT(timeOf({1.0, -1.0, 0.0}, wall()), 0.99);
}

TEST(ArcContact, WhatComesHitsWhoStandsAndWhoTurns)
{
  EXPECT_NEAR(timeOf({}, wall({-0.5, 0.0})), 2.0, kClose);
  EXPECT_NEAR(timeOf({0.0, 0.0, 3.0}, wall({-0.5, 0.0})), 2.0, kClose);
  EXPECT_EQ(timeOf({}, wall({0.5, 0.0})), -1.0);
  EXPECT_NEAR(timeOf({0.5, 0.0, 0.0}, wall({-0.5, 0.0})), 1.0, kClose);
  EXPECT_EQ(timeOf({0.5, 0.0, 0.0}, wall({0.5, 0.0})), -1.0) << "as fast as it goes away";
  EXPECT_EQ(timeOf({}, wall({-0.5, 2.5})), -1.0) << "it passes by";
}

TEST(ArcContact, WhatGrowsComesToAllSides)
{
  EXPECT_NEAR(timeOf({}, wall({0.0, 0.0}, 0.25)), 4.0, kClose);
  EXPECT_NEAR(timeOf({0.25, 0.0, 0.0}, wall({0.0, 0.0}, 0.25)), 2.0, kClose);
  // Beside its end by 0.1 m: it has grown longer by more than that.
  EXPECT_NEAR(timeOf({}, wall({0.0, 0.0}, 0.25), 10.0, {{0.0, 1.1}, 0.0}), 4.0, kClose);
}

TEST(ArcContact, OnAClockThatHasRun)
{
  const Arc later(Pose{}, {0.5, 0.0, 0.0}, 3.0);
  EXPECT_NEAR(firstContact(later, wall({0.1, 0.0}), 3.0, 20.0).value_or(-1.0), 6.25, kClose);
  EXPECT_NEAR((later.position(5.0) - Eigen::Vector2d(1.0, 0.0)).norm(), 0.0, 1e-15);
}

TEST(MovingEdges, WhatGrowsHasNoGapAtSharpCorners)
{
  geometry::PolygonSet needle;
  needle.append(std::vector<Eigen::Vector2d>{{0.0, 0.0}, {2.0, 0.0}, {0.0, 0.2}}, false);
  std::vector<MovingEdge> edges;
  appendMovingEdges(needle, Eigen::Vector2d::Zero(), 0.0, edges);
  EXPECT_EQ(edges.size(), 3U);
  edges.clear();
  appendMovingEdges(needle, Eigen::Vector2d::Zero(), 0.1, edges);
  ASSERT_EQ(edges.size(), 5U)
      << "the tip and the right angle, which is a little sharper than that at (0, 0.2)";
  // Straight at the tip.
  const Arc arc(Pose{{4.0, 0.0}, M_PI}, {0.5, 0.0, 0.0});
  double first = 10.0;
  for (const MovingEdge& edge : edges)
    first = std::min(first, firstContact(arc, edge, 0.0, 10.0).value_or(10.0));
  EXPECT_NEAR(first, 2.0 / 0.6, 0.01);
}

}  // namespace
}  // namespace polygonal_perception::planning

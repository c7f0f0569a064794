#include <gtest/gtest.h>

#include <random>

#include "polygonal_perception/geometry/distance.hpp"
#include "polygonal_perception/geometry/location.hpp"
#include "polygonal_perception/planning/free_space.hpp"

namespace polygonal_perception::planning {
namespace {

using geometry::PolygonSet;
using Ring = std::vector<Eigen::Vector2d>;

Ring square(double x, double y, double side)
{
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

/// A room of 4 x 4 m whose walls are 1 m thick.
PolygonSet room()
{
  PolygonSet set;
  set.append(square(-1, -1, 6), false);
  Ring hole = square(0, 0, 4);
  std::reverse(hole.begin(), hole.end());
  set.append(hole, true);
  return set;
}

TEST(FreeSpace, IsEverywhereWithoutObstacles)
{
  FreeSpace space;
  ASSERT_FALSE(space.build({}));
  EXPECT_TRUE(space.locate({3.0, -700.0}));
  EXPECT_FALSE(space.locate({3.0, 1e9})) << "beyond the square";
  EXPECT_FALSE(space.nearest({0.0, 0.0})) << "there is no border";
}

TEST(FreeSpace, WallsAreBlockedAndTheirBordersAreFree)
{
  FreeSpace space;
  ASSERT_FALSE(space.build(room()));
  EXPECT_TRUE(space.locate({2, 2}));
  EXPECT_FALSE(space.locate({-0.5, 2}));
  EXPECT_TRUE(space.locate({0, 2})) << "an edge";
  EXPECT_TRUE(space.locate({0, 0})) << "a corner";
  EXPECT_TRUE(space.locate({9, 9}));
}

TEST(FreeSpace, OnlyCornersOfMoreThanHalfATurnOfFreedomAreCorners)
{
  FreeSpace space;
  ASSERT_FALSE(space.build(room()));
  for (const auto& [corner, inside, is_corner] :
       {std::tuple(Eigen::Vector2d(-1, -1), Eigen::Vector2d(-1.1, -1.1), true),
        std::tuple(Eigen::Vector2d(0, 0), Eigen::Vector2d(0.1, 0.1), false)}) {
    const auto place = space.locate(corner);
    ASSERT_TRUE(place && place->at_origin);
    EXPECT_EQ(space.corner(place->half_edge) != nullptr, is_corner) << corner.transpose();
  }
}

TEST(FreeSpace, ThePointWhereTwoObstaclesTouchIsTwoCorners)
{
  PolygonSet set;
  set.append(square(0, 0, 1), false);
  set.append(square(1, 1, 1), false);
  FreeSpace space;
  ASSERT_FALSE(space.build(set));
  const auto place = space.locate({1, 1});
  ASSERT_TRUE(place && place->at_origin);
  // A quarter turn of freedom on each side: neither is a corner around which a path bends.
  EXPECT_EQ(space.corner(place->half_edge), nullptr);
}

TEST(FreeSpace, NearestIsOnTheBorder)
{
  FreeSpace space;
  ASSERT_FALSE(space.build(room()));
  const auto place = space.nearest({-0.3, 2});
  ASSERT_TRUE(place);
  EXPECT_EQ(place->point, Eigen::Vector2d(0, 2));
  EXPECT_TRUE(space.isFree(place->half_edge));
  const auto corner = space.nearest({-2, -3});
  ASSERT_TRUE(corner && corner->at_origin);
  EXPECT_EQ(corner->point, Eigen::Vector2d(-1, -1));
}

TEST(FreeSpace, RefusesRingsThatRunTheWrongWay)
{
  Ring clockwise = square(0, 0, 1);
  std::reverse(clockwise.begin(), clockwise.end());
  PolygonSet set;
  set.append(clockwise, false);
  FreeSpace space;
  const auto fault = space.build(set);
  ASSERT_TRUE(fault);
  EXPECT_NE(fault->text.find("clockwise"), std::string::npos) << fault->text;
  EXPECT_FALSE(space.locate({5, 5})) << "there is no free space";
}

TEST(FreeSpace, WhatSeveralObstaclesContainIsBlocked)
{
  PolygonSet set;
  set.append(square(0, 0, 3), false);
  set.append(square(1, 1, 1), false);
  set.append(square(2, -1, 3), false);
  FreeSpace space;
  ASSERT_FALSE(space.build(set));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-2.0, 6.0);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector2d p(place(random), place(random));
    const auto within = [&](double x, double y, double side) {
      return p.x() > x && p.x() < x + side && p.y() > y && p.y() < y + side;
    };
    const bool blocked = within(0, 0, 3) || within(2, -1, 3);
    ASSERT_EQ(space.locate(p).has_value(), !blocked) << p.transpose();
  }
}

}  // namespace
}  // namespace polygonal_perception::planning

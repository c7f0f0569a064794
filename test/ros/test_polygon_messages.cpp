#include <gtest/gtest.h>

#include <limits>

#include "polygonal_perception/ros/common/polygon_messages.hpp"

namespace polygonal_perception::ros_common {
namespace {

using Vertices = std::vector<Eigen::Vector2d>;

/// A triangle with a hole, and another triangle.
geometry::PolygonSet polygons()
{
  geometry::PolygonSet polygons;
  polygons.append(Vertices{{0, 0}, {3, 0}, {0, 3}}, false);
  polygons.append(Vertices{{1, 1}, {1, 1.5}, {1.5, 1}}, true);
  polygons.append(Vertices{{5, 5}, {6, 5}, {5, 6}}, false);
  return polygons;
}

/// 2 m ahead, 1 m to the left, turned by a quarter to the left.
Eigen::Isometry2d quarterTurn()
{
  Eigen::Isometry2d pose = Eigen::Isometry2d::Identity();
  pose.linear() << 0.0, -1.0, 1.0, 0.0;
  pose.translation() << 2.0, 1.0;
  return pose;
}

PolygonContext context(std::uint8_t floor_status)
{
  PolygonContext context;
  context.header.stamp = ros::Time(12, 34);
  context.header.frame_id = "frame";
  context.floor_status = floor_status;
  context.inflation_radius = 0.25;
  context.extent = {Eigen::Vector2d(0.0, -2.0), Eigen::Vector2d(4.0, 2.0)};
  return context;
}

TEST(PolygonMessages, HolesGoToTheirPolygon)
{
  const PolygonArrayPtr message = toPolygonArray(context(FloorPlane::HELD), polygons(), quarterTurn());
  EXPECT_EQ(message->header.stamp, ros::Time(12, 34));
  EXPECT_EQ(message->header.frame_id, "frame");
  EXPECT_EQ(message->floor_status, FloorPlane::HELD);
  EXPECT_EQ(message->inflation_radius, 0.25);
  ASSERT_EQ(message->polygons.size(), 2U);
  EXPECT_EQ(toVertices(message->polygons[0].boundary), (Vertices{{2, 1}, {2, 4}, {-1, 1}}));
  ASSERT_EQ(message->polygons[0].holes.size(), 1U);
  EXPECT_EQ(toVertices(message->polygons[0].holes[0]), (Vertices{{1, 2}, {0.5, 2}, {1, 2.5}}));
  EXPECT_TRUE(message->polygons[1].holes.empty());
}

TEST(PolygonMessages, TheExtentIsTurnedAndRunsCounterClockwise)
{
  const PolygonArrayPtr message = toPolygonArray(context(FloorPlane::FOUND), {}, quarterTurn());
  EXPECT_EQ(toVertices(message->extent), (Vertices{{4, 1}, {4, 5}, {0, 5}, {0, 1}}));
}

TEST(PolygonMessages, WithoutAFloorNothingIsKnownAnywhere)
{
  const PolygonArrayPtr message = toPolygonArray(context(FloorPlane::NOT_FOUND), polygons(), quarterTurn());
  EXPECT_EQ(message->floor_status, FloorPlane::NOT_FOUND);
  EXPECT_TRUE(message->polygons.empty());
  EXPECT_TRUE(message->extent.points.empty());
  EXPECT_EQ(message->inflation_radius, 0.25);
}

TEST(PolygonMessages, AnEmptyExtentStaysEmpty)
{
  PolygonContext nothing = context(FloorPlane::FOUND);
  nothing.extent.setEmpty();
  EXPECT_TRUE(toPolygonArray(nothing, {}, quarterTurn())->extent.points.empty());
}

TEST(PolygonMessages, ThereAndBack)
{
  const PolygonArrayPtr message =
      toPolygonArray(context(FloorPlane::FOUND), polygons(), Eigen::Isometry2d::Identity());
  const auto back = toPolygonSet(*message);
  ASSERT_TRUE(back) << back.error();
  EXPECT_EQ(back->vertices, polygons().vertices);
  ASSERT_EQ(back->rings.size(), 3U);
  for (std::size_t r = 0; r < 3; ++r) {
    EXPECT_EQ(back->rings[r].first, 3 * r);
    EXPECT_EQ(back->rings[r].size, 3U);
    EXPECT_EQ(back->rings[r].hole, r == 1);
  }
  const auto first = toPolygonSet(message->polygons[0]);
  ASSERT_TRUE(first) << first.error();
  EXPECT_EQ(first->rings.size(), 2U);
  EXPECT_TRUE(toPolygonSet(PolygonArray())) << "no polygons are polygons, too";
}

TEST(PolygonMessages, AnErrorNamesPolygonRingAndVertex)
{
  const PolygonArrayPtr good =
      toPolygonArray(context(FloorPlane::FOUND), polygons(), Eigen::Isometry2d::Identity());
  PolygonArray message = *good;
  message.polygons[1].boundary.points.pop_back();
  EXPECT_EQ(toPolygonSet(message).error(), "polygon 1: the boundary has 2 vertices, fewer than 3");
  EXPECT_EQ(toPolygonSet(message.polygons[1]).error(), "the boundary has 2 vertices, fewer than 3");

  message = *good;
  message.polygons[0].holes[0].points.clear();
  EXPECT_EQ(toPolygonSet(message).error(), "polygon 0: hole 0 has 0 vertices, fewer than 3");

  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    for (float geometry_msgs::Point32::*coordinate :
         {&geometry_msgs::Point32::x, &geometry_msgs::Point32::y, &geometry_msgs::Point32::z}) {
      message = *good;
      message.polygons[0].boundary.points[2].*coordinate = bad;
      EXPECT_EQ(toPolygonSet(message).error(),
                "polygon 0: the boundary has a coordinate that is not finite, in vertex 2");
    }
  }
}

}  // namespace
}  // namespace polygonal_perception::ros_common

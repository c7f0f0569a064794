#include <gtest/gtest.h>

#include "polygonal_perception/ros/common/polygon_markers.hpp"
#include "ros/perception/markers.hpp"

namespace polygonal_perception::ros_perception {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

/// A square of 4 x 4 with a square hole of 2 x 2.
geometry::PolygonSet squareRing()
{
  geometry::PolygonSet polygons;
  polygons.vertices = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {1, 3}, {3, 3}, {3, 1}};
  polygons.rings = {{0, 4, false}, {4, 4, true}};
  return polygons;
}

TEST(Markers, FillHasTheAreaAndOutlineTheEdgesOfThePolygons)
{
  MarkerArray markers;
  Eigen::Isometry2d pose = Eigen::Isometry2d::Identity();
  pose.translation() << 10.0, 0.0;
  ros_common::appendPolygonMarkers(std_msgs::Header(), squareRing(), pose, ros_common::kFrameColor, markers);
  ASSERT_EQ(markers.markers.size(), 2U);
  const Marker& fill = markers.markers[0];
  const Marker& outline = markers.markers[1];
  EXPECT_EQ(fill.ns, "polygons/fill");
  EXPECT_EQ(fill.type, Marker::TRIANGLE_LIST);
  EXPECT_EQ(fill.action, Marker::ADD);
  ASSERT_EQ(fill.points.size() % 3, 0U);
  double area = 0.0;
  for (std::size_t i = 0; i < fill.points.size(); i += 3) {
    const auto& a = fill.points[i];
    const auto& b = fill.points[i + 1];
    const auto& c = fill.points[i + 2];
    area += ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2.0;
    EXPECT_GE(a.x, 10.0);
  }
  EXPECT_NEAR(area, 12.0, 1e-9);

  EXPECT_EQ(outline.type, Marker::LINE_LIST);
  ASSERT_EQ(outline.points.size(), 16U);
  double length = 0.0;
  for (std::size_t i = 0; i < outline.points.size(); i += 2) {
    length += std::hypot(outline.points[i + 1].x - outline.points[i].x,
                         outline.points[i + 1].y - outline.points[i].y);
  }
  EXPECT_NEAR(length, 24.0, 1e-9);
}

TEST(Markers, NoPolygonsTakeTheOldOnesAway)
{
  MarkerArray markers;
  ros_common::appendPolygonMarkers(std_msgs::Header(), geometry::PolygonSet(), Eigen::Isometry2d::Identity(),
                                   ros_common::kFrameColor, markers);
  ASSERT_EQ(markers.markers.size(), 2U);
  EXPECT_EQ(markers.markers[0].action, Marker::DELETE);
  EXPECT_EQ(markers.markers[1].action, Marker::DELETE);
}

TEST(Markers, TheNormalStandsUnderTheCamera)
{
  perception::FloorState floor;
  floor.status = perception::FloorStatus::kFound;
  floor.floor.plane = {-Eigen::Vector3d::UnitY(), 1.5};
  MarkerArray markers;
  appendFloorMarkers(std_msgs::Header(), floor, {{0, 1.5F, 1}, {1, 1.5F, 1}, {0, 1.5F, 2}}, markers);
  ASSERT_EQ(markers.markers.size(), 2U);
  ASSERT_EQ(markers.markers[0].points.size(), 2U);
  EXPECT_EQ(markers.markers[0].points[0].y, 1.5);
  EXPECT_EQ(markers.markers[0].points[1].y, 1.0);
  ASSERT_EQ(markers.markers[1].points.size(), 4U) << "closed";
  EXPECT_EQ(markers.markers[1].points.front(), markers.markers[1].points.back());
}

TEST(Markers, NoFloorTakesTheOldOneAway)
{
  MarkerArray markers;
  appendFloorMarkers(std_msgs::Header(), perception::FloorState(), {{0, 1.5F, 1}, {1, 1.5F, 1}, {0, 1.5F, 2}},
                     markers);
  ASSERT_EQ(markers.markers.size(), 2U);
  EXPECT_EQ(markers.markers[0].action, Marker::DELETE);
  EXPECT_EQ(markers.markers[1].action, Marker::DELETE);
}

}  // namespace
}  // namespace polygonal_perception::ros_perception

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>

#include "rviz/message_geometry.hpp"

namespace polygonal_perception::displays {
namespace {

/// In an optical frame, 1.5 m above the floor.
FloorPlane levelFloor()
{
  FloorPlane floor;
  floor.status = FloorPlane::FOUND;
  floor.normal.y = -1.0;
  floor.distance = 1.5;
  for (const Eigen::Vector2f& corner :
       {Eigen::Vector2f(1, 1), Eigen::Vector2f(1, 3), Eigen::Vector2f(-1, 3), Eigen::Vector2f(-1, 1)}) {
    geometry_msgs::Point32& point = floor.hull.emplace_back();
    point.x = corner.x();
    point.y = 1.5F;
    point.z = corner.y();
  }
  return floor;
}

TEST(MessageGeometry, AFloorNeedsAUnitNormalAndFiniteNumbers)
{
  EXPECT_TRUE(isDrawable(levelFloor()));
  FloorPlane floor = levelFloor();
  floor.normal.y = -2.0;
  EXPECT_FALSE(isDrawable(floor));
  floor.normal.y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(isDrawable(floor));
  floor = levelFloor();
  floor.distance = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(isDrawable(floor));
  floor = levelFloor();
  floor.hull.back().z = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(isDrawable(floor));
}

TEST(MessageGeometry, TheFootIsUnderTheOrigin)
{
  EXPECT_EQ(footOf(levelFloor()), Eigen::Vector3d(0.0, 1.5, 0.0));
}

TEST(MessageGeometry, APatchIsASquareAroundTheHull)
{
  const std::vector<Eigen::Vector3d> patch = patchOf(levelFloor(), 4.0);
  ASSERT_EQ(patch.size(), 4U);
  const Eigen::Vector3d middle = (patch[0] + patch[1] + patch[2] + patch[3]) / 4.0;
  EXPECT_TRUE(middle.isApprox(Eigen::Vector3d(0.0, 1.5, 2.0), 1e-6)) << middle.transpose();
  const Eigen::Vector3d up(0.0, -1.0, 0.0);
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d side = patch[(i + 1) % 4] - patch[i];
    const Eigen::Vector3d next = patch[(i + 2) % 4] - patch[(i + 1) % 4];
    EXPECT_NEAR(side.norm(), 4.0, 1e-6);
    EXPECT_NEAR(patch[i].y(), 1.5, 1e-6);
    EXPECT_NEAR(up.dot(side.cross(next)), 16.0, 1e-5) << "counter-clockwise from above";
  }
}

TEST(MessageGeometry, APatchWithoutAHullLiesUnderTheOrigin)
{
  FloorPlane floor = levelFloor();
  floor.hull.clear();
  const std::vector<Eigen::Vector3d> patch = patchOf(floor, 1.0);
  ASSERT_EQ(patch.size(), 4U);
  EXPECT_TRUE(((patch[0] + patch[2]) / 2.0).isApprox(footOf(floor), 1e-9));
}

/// An L of 3 m^2 on a wall 2 m ahead of an optical frame.
Plane wall()
{
  Plane wall;
  wall.normal.z = -1.0;
  wall.distance = 2.0;
  for (const Eigen::Vector2f& corner :
       {Eigen::Vector2f(0, 0), Eigen::Vector2f(0, 2), Eigen::Vector2f(1, 2), Eigen::Vector2f(1, 1),
        Eigen::Vector2f(2, 1), Eigen::Vector2f(2, 0)}) {
    geometry_msgs::Point32& point = wall.boundary.emplace_back();
    point.x = corner.x();
    point.y = corner.y();
    point.z = 2.0F;
  }
  return wall;
}

TEST(MessageGeometry, APlaneNeedsAUnitNormalFiniteNumbersAndThreePoints)
{
  EXPECT_TRUE(isDrawable(wall()));
  Plane plane = wall();
  plane.normal.z = 0.5;
  EXPECT_FALSE(isDrawable(plane));
  plane = wall();
  plane.distance = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(isDrawable(plane));
  plane = wall();
  plane.boundary[1].x = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(isDrawable(plane));
  plane = wall();
  plane.boundary.resize(2);
  EXPECT_FALSE(isDrawable(plane));
}

TEST(MessageGeometry, ThePlanesAreaIsThatInsideOfItsBoundary)
{
  const std::vector<Eigen::Vector3d> corners = trianglesOf(wall());
  ASSERT_EQ(corners.size() % 3, 0U);
  double area = 0.0;
  for (std::size_t k = 0; k < corners.size(); k += 3) {
    area += 0.5 * (corners[k + 1] - corners[k]).cross(corners[k + 2] - corners[k]).norm();
    for (std::size_t corner = k; corner < k + 3; ++corner)
      EXPECT_NEAR(corners[corner].z(), 2.0, 1e-9) << "corner " << corner << " is not on the plane";
  }
  EXPECT_NEAR(area, 3.0, 1e-6);
}

}  // namespace
}  // namespace polygonal_perception::displays

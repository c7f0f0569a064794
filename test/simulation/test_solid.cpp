#include <gtest/gtest.h>

#include "polygonal_perception/cameras/simulation/solid.hpp"

namespace polygonal_perception::simulation {
namespace {

double area(const Outline& outline)
{
  double twice = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d& a = outline[i];
    const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

TEST(Solid, FootprintOfABoxIsItsRectangleCounterClockwise)
{
  const Eigen::Isometry3d pose(Eigen::Translation3d(1.0, 2.0, 0.5));
  const Outline outline = footprint(makeBox(pose, {0.4, 0.2, 1.0}), 0.03, 0.6);
  ASSERT_EQ(outline.size(), 4U);
  EXPECT_NEAR(area(outline), 0.08, 1e-6) << "positive means counter-clockwise";
  EXPECT_NEAR(outline[0].x(), 0.8, 1e-6);
  EXPECT_NEAR(outline[0].y(), 1.9, 1e-6);
}

TEST(Solid, FootprintIsOnlyOfThePartWithinTheHeights)
{
  // A cone of radius 0.5 at the floor and 0 at 1 m: at 0.5 m and above it is no wider than 0.25.
  const Solid cone = makeFrustum({0, 0, 0}, {0, 0, 1}, 0.5, 0.0);
  for (const Eigen::Vector2d& p : footprint(cone, 0.5, 2.0)) EXPECT_LE(p.norm(), 0.25 + 1e-6);
  EXPECT_TRUE(footprint(cone, 1.5, 2.0).empty());
  EXPECT_TRUE(footprint(makeLevelRectangle({0, 0}, {1, 1}, 0.0), 0.03, 0.6).empty())
      << "a floor is no obstacle";
}

TEST(Solid, SlabBetweenTheVerticesHasAFootprint)
{
  const Outline outline = footprint(makeBox(Eigen::Isometry3d::Identity(), {1.0, 1.0, 10.0}), 0.03, 0.6);
  EXPECT_NEAR(area(outline), 1.0, 1e-6);
}

TEST(Solid, DistanceIsZeroInsideAndToTheNearestPointOutside)
{
  const Outline square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_EQ(distanceTo(square, {0.5, 0.5}), 0.0);
  EXPECT_DOUBLE_EQ(distanceTo(square, {0.5, -2.0}), 2.0);
  EXPECT_DOUBLE_EQ(distanceTo(square, {4.0, 5.0}), 5.0);
}

TEST(Solid, DistanceToALineHasNoInside)
{
  const Outline line{{0, 0}, {2, 0}};
  EXPECT_DOUBLE_EQ(distanceTo(line, {1.0, 0.5}), 0.5);
  EXPECT_DOUBLE_EQ(distanceTo(line, {1.0, -0.5}), 0.5);
}

TEST(Solid, TrianglesFaceOutwards)
{
  const Eigen::Isometry3d pose(Eigen::Translation3d(3.0, -1.0, 0.5));
  for (const Solid& solid : {makeBox(pose, {1, 2, 3}), makeEllipsoid(pose, {1, 2, 3}),
                             makeFrustum({3, -1, -1}, {3, -1, 2}, 1.0, 0.5)}) {
    const Eigen::Vector3f centre(3.0F, -1.0F, 0.5F);
    for (const auto& t : solid.triangles) {
      const Eigen::Vector3f a = solid.vertices[t[0]];
      const Eigen::Vector3f normal = (solid.vertices[t[1]] - a).cross(solid.vertices[t[2]] - a);
      EXPECT_GT(normal.dot(a - centre), 0.0F) << t[0] << ' ' << t[1] << ' ' << t[2];
    }
  }
}

}  // namespace
}  // namespace polygonal_perception::simulation

#include <gtest/gtest.h>

#include <cmath>

#include "polygonal_perception/geometry/measures.hpp"

namespace polygonal_perception::geometry {
namespace {

using Vertices = std::vector<Eigen::Vector2d>;

/// An L of 3 square metres with a hole of a sixteenth.
PolygonSet lShape()
{
  PolygonSet polygons;
  polygons.append(Vertices{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, false);
  polygons.append(Vertices{{0.25, 0.25}, {0.25, 0.5}, {0.5, 0.5}, {0.5, 0.25}}, true);
  return polygons;
}

TEST(Measures, AreasHaveTheSignOfTheRing)
{
  EXPECT_EQ(signedArea(Vertices{{0, 0}, {4, 0}, {0, 3}}), 6.0);
  EXPECT_EQ(signedArea(Vertices{{0, 3}, {4, 0}, {0, 0}}), -6.0);
  EXPECT_EQ(signedArea(Vertices{}), 0.0);
  EXPECT_EQ(area(lShape()), 3.0 - 0.0625);
  EXPECT_EQ(area(PolygonSet()), 0.0);
}

TEST(Measures, AnAreaFarFromTheOriginIsNotRoundedAway)
{
  const double far = 1e9;
  EXPECT_EQ(signedArea(Vertices{{far, far}, {far + 1, far}, {far + 1, far + 1}, {far, far + 1}}), 1.0);
}

TEST(Measures, BoundsHoldAllVertices)
{
  const Eigen::AlignedBox2d box = bounds(lShape());
  EXPECT_EQ(box.min(), Eigen::Vector2d(0, 0));
  EXPECT_EQ(box.max(), Eigen::Vector2d(2, 2));
  EXPECT_TRUE(bounds(PolygonSet()).isEmpty());
  const PolygonSet polygons = lShape();
  EXPECT_EQ(bounds(polygons.view(polygons.rings[1])).max(), Eigen::Vector2d(0.5, 0.5));
}

TEST(Measures, TransformedTurnsThenShifts)
{
  const Eigen::Isometry2d pose = Eigen::Translation2d(10, 20) * Eigen::Rotation2Dd(M_PI / 2);
  const PolygonSet moved = transformed(lShape(), pose);
  EXPECT_TRUE(moved.vertices[1].isApprox(Eigen::Vector2d(10, 22), 1e-12)) << moved.vertices[1].transpose();
  EXPECT_TRUE(moved.vertices[5].isApprox(Eigen::Vector2d(8, 20), 1e-12)) << moved.vertices[5].transpose();
  ASSERT_EQ(moved.rings.size(), 2U);
  EXPECT_TRUE(moved.rings[1].hole);
  EXPECT_NEAR(area(moved), area(lShape()), 1e-12);
}

TEST(Measures, TheCrossProductIsPositiveToTheLeft)
{
  EXPECT_EQ(cross({1, 0}, {0, 1}), 1.0);
  EXPECT_EQ(cross({0, 2}, {3, 0}), -6.0);
}

}  // namespace
}  // namespace polygonal_perception::geometry

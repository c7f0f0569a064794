#include <gtest/gtest.h>

#include <cmath>

#include "polygonal_perception/geometry/angle.hpp"

namespace polygonal_perception::geometry {
namespace {

constexpr double kPi = 3.14159265358979323846;

TEST(AngleBetween, IsThatOfVectorsOfAnyLength)
{
  EXPECT_NEAR(angleBetween({2, 0, 0}, {0, 0, 5}), kPi / 2, 1e-12) << "a right angle, lengths 2 and 5";
  EXPECT_NEAR(angleBetween({0, 0.1, 0}, {7, 7, 0}), kPi / 4, 1e-12)
      << "half a right angle, lengths 0.1 and 10";
}

TEST(AngleBetween, SmallAnglesKeepTheirDigits)
{
  // An arc cosine would say 0: the cosine of 1e-9 is 1 to the last digit.
  EXPECT_NEAR(angleBetween({1, 0, 0}, {1, 1e-9, 0}), 1e-9, 1e-15);
}

TEST(AngleBetween, ReachesFromNoneToHalfATurn)
{
  EXPECT_EQ(angleBetween({0, 3, 0}, {0, 5, 0}), 0.0) << "one direction";
  EXPECT_NEAR(angleBetween({1, 0, 0}, {-3, 0, 0}), kPi, 1e-12) << "opposite directions";
  // And just short of it, where an arc cosine has no digits left either.
  EXPECT_NEAR(kPi - angleBetween({1, 0, 0}, {-1, 1e-9, 0}), 1e-9, 1e-15);
}

TEST(AngleBetween, DoesNotDependOnWhichComesFirst)
{
  const Eigen::Vector3d a(0.3, -1.2, 0.7);
  const Eigen::Vector3d b(-2.0, 0.1, 0.4);
  EXPECT_EQ(angleBetween(a, b), angleBetween(b, a));
  EXPECT_GT(angleBetween(a, b), 0.0) << "angles have no sign";
}

}  // namespace
}  // namespace polygonal_perception::geometry

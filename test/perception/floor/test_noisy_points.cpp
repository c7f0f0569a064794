#include <gtest/gtest.h>

#include <cmath>

#include "perception/floor/noisy_points.hpp"

namespace polygonal_perception::perception {
namespace {

const geometry::Plane kFloor{Eigen::Vector3d::UnitZ(), 1.0};
const NoisyPoints::Band kBand{3.0F, 0.1F, 3.0F};

TEST(NoisyPoints, FarPointsMayLieFartherOff)
{
  NoisyPoints points;
  // 3 cm over the floor, 1 m below the camera and 5 m away.
  points.add({0.1F, 0.0F, -0.97F});
  points.add({5.0F, 0.0F, -0.97F});
  points.computeResiduals(kFloor, kBand);
  EXPECT_FALSE(points.on(0));
  EXPECT_TRUE(points.on(1));
}

TEST(NoisyPoints, TheBandIsNeverWiderThanItsLimit)
{
  NoisyPoints points;
  points.add({30.0F, 0.0F, -0.85F});
  points.computeResiduals(kFloor, kBand);
  EXPECT_FALSE(points.on(0));
}

TEST(NoisyPoints, CountsWhatIsClearlyBelow)
{
  NoisyPoints points;
  points.add({1.0F, 0.0F, -1.0F});  // on the floor
  points.add({1.0F, 0.0F, -0.5F});  // above it
  points.add({1.0F, 0.0F, -1.3F});  // below it
  points.add({1.0F, 0.0F, -4.0F});  // deeper than any floor could be
  points.add({NAN, NAN, NAN});      // no return
  points.computeResiduals(kFloor, kBand);
  EXPECT_EQ(points.counts().inliers, 1);
  EXPECT_EQ(points.counts().below, 1);
}

TEST(NoisyPoints, TellASurfaceAlongThePlaneFromOneAcross)
{
  NoisyPoints points;
  points.add({1.0F, 0.0F, -1.0F});
  points.add({1.1F, 0.0F, -1.0F});  // along
  points.add({1.0F, 0.0F, -0.9F});  // up a wall
  points.add({NAN, NAN, NAN});      // a hole says nothing
  points.computeResiduals(kFloor, kBand);
  EXPECT_TRUE(points.runsAlong(0, 1));
  EXPECT_FALSE(points.runsAlong(0, 2));
  EXPECT_TRUE(points.runsAlong(0, 3));
}

TEST(NoisyPoints, PickTakesEverySoManyOfPlenty)
{
  NoisyPoints points;
  for (int k = 0; k < 100; ++k) points.add({0.01F * k, 0.5F, -1.0F});
  points.computeResiduals(kFloor, kBand);
  std::vector<std::uint32_t> picked;
  points.pick([](std::size_t) { return true; }, 10, picked);
  EXPECT_EQ(picked.size(), 10U);
  points.pick([](std::size_t) { return true; }, 1000, picked);
  EXPECT_EQ(picked.size(), 100U);
}

TEST(NoisyPoints, OfNoneNothingIsPicked)
{
  NoisyPoints points;
  points.computeResiduals(kFloor, kBand);
  std::vector<std::uint32_t> picked(3);
  EXPECT_EQ(points.pick([](std::size_t) { return true; }, 0, picked), 0U);
  EXPECT_TRUE(picked.empty());
}

}  // namespace
}  // namespace polygonal_perception::perception

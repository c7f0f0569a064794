#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "perception/floor/noisy_pixels.hpp"

namespace polygonal_perception::perception {
namespace {

const geometry::Plane kFloor{Eigen::Vector3d::UnitZ(), 1.0};
const NoisyPixels::Band kBand{3.0F, 0.1F, 0.003F, 0.003F};
const float kNaN = std::numeric_limits<float>::quiet_NaN();
const Eigen::Vector3f kNoReturn(kNaN, kNaN, kNaN);

SensorNoise noNoise()
{
  SensorNoise noise;
  noise.constant = noise.linear = noise.quadratic = 0.0;
  return noise;
}

/// Pixels that are held against the floor.
NoisyPixels heldAgainst(const std::vector<Eigen::Vector3f>& points, std::size_t columns = 1,
                        const NoisyPixels::Band& band = kBand, const SensorNoise& noise = {})
{
  NoisyPixels pixels;
  pixels.resize(points.size(), columns);
  for (std::size_t k = 0; k < points.size(); ++k) pixels.set(k, points[k]);
  pixels.measure(noise);
  pixels.computeResiduals(kFloor, band);
  return pixels;
}

TEST(NoisyPixels, FarPointsMayLieFartherOff)
{
  // 3 cm over the floor, 1 m below the camera and 5 m away.
  const NoisyPixels pixels = heldAgainst({{0.1F, 0.0F, -0.97F}, {5.0F, 0.0F, -0.97F}});
  EXPECT_FALSE(pixels.on(0));
  EXPECT_TRUE(pixels.on(1));
  EXPECT_EQ(pixels.inliers(), 1U);
}

TEST(NoisyPixels, TheBandReachesToBothSides)
{
  // 3 times 6 mm, a metre below the camera and without noise.
  const NoisyPixels pixels =
      heldAgainst({{0, 0, -1.016F}, {0, 0, -0.984F}, {0, 0, -1.020F}, {0, 0, -0.980F}}, 1, kBand, noNoise());
  EXPECT_TRUE(pixels.on(0));
  EXPECT_TRUE(pixels.on(1));
  EXPECT_FALSE(pixels.on(2));
  EXPECT_FALSE(pixels.on(3));
}

TEST(NoisyPixels, TheNoiseOfTheDepthCountsAlongTheNormal)
{
  // 1 % of the range: 5 cm at 5 m, of which a fifth is across a floor 1 m below.
  SensorNoise noise = noNoise();
  noise.linear = 0.01;
  const NoisyPixels::Band band{1.0F, 1.0F, 0.0F, 0.0F};
  const float x = std::sqrt(24.0F);
  const NoisyPixels pixels = heldAgainst({{x, 0, -0.991F}, {x, 0, -0.989F}}, 1, band, noise);
  EXPECT_TRUE(pixels.on(0)) << "9 mm off";
  EXPECT_FALSE(pixels.on(1)) << "11 mm off";
  EXPECT_NEAR(pixels.normalizedResidual(0), 0.9, 0.02);
}

TEST(NoisyPixels, TheBandIsNeverWiderThanItsLimit)
{
  EXPECT_FALSE(heldAgainst({{30.0F, 0.0F, -0.85F}}).on(0));
}

TEST(NoisyPixels, APixelWithoutAReturnIsOnNoPlaneAndBelowNone)
{
  const NoisyPixels pixels = heldAgainst({kNoReturn, {1.0F, kNaN, -1.0F}});
  EXPECT_EQ(pixels.inliers(), 0U);
  EXPECT_FALSE(pixels.on(0));
  EXPECT_FALSE(pixels.on(1));
  pixels.forEachBelow(0.0F, 0.0F, [](std::size_t k, float, float) { ADD_FAILURE() << k << " is below"; });
}

TEST(NoisyPixels, VisitsWhatIsClearlyBelow)
{
  const NoisyPixels pixels = heldAgainst({{1.0F, 0.0F, -1.0F},    // on the floor
                                          {1.0F, 0.0F, -0.5F},    // above it
                                          {1.0F, 0.0F, -1.3F},    // below it
                                          {1.0F, 0.0F, -1.02F},   // not clearly
                                          {6.0F, 0.0F, -1.1F}});  // nor so far away
  std::vector<std::size_t> below;
  pixels.forEachBelow(4.0F, 0.006F, [&](std::size_t k, float height, float sigma) {
    below.push_back(k);
    EXPECT_NEAR(height, -0.3, 1e-5);
    EXPECT_GT(sigma, 0.006F) << "at least the model error, 1.6 m away";
    EXPECT_LT(sigma, 0.02F);
  });
  EXPECT_EQ(below, std::vector<std::size_t>{2});
}

TEST(NoisyPixels, HowClearlyBelowIsAsked)
{
  const NoisyPixels pixels = heldAgainst({{0.0F, 0.0F, -1.05F}}, 1, kBand, noNoise());
  const auto count = [&](float sigmas, float slope) {
    int below = 0;
    pixels.forEachBelow(sigmas, slope, [&](std::size_t, float, float) { ++below; });
    return below;
  };
  EXPECT_EQ(count(4.0F, 0.01F), 1) << "5 cm, of 4 times 1.05 cm";
  EXPECT_EQ(count(5.0F, 0.01F), 0) << "5 cm, of 5 times 1.05 cm";
  EXPECT_EQ(count(4.0F, 0.013F), 0) << "5 cm, of 4 times 1.37 cm";
}

TEST(NoisyPixels, WhatIsNearerToAnotherPlaneIsItsOwn)
{
  // In the band 1 cm, 2 cm and 4 cm over the floor; the other plane lies 5 cm over it.
  const NoisyPixels::Band wide{100.0F, 0.1F, 0.003F, 0.003F};
  NoisyPixels pixels = heldAgainst({{0, 0, -0.99F}, {0, 0, -0.98F}, {0, 0, -0.96F}, {0, 0, -0.5F}}, 1, wide);
  ASSERT_EQ(pixels.inliers(), 3U);
  pixels.giveTo({Eigen::Vector3d::UnitZ(), 0.95});
  EXPECT_TRUE(pixels.on(0));
  EXPECT_TRUE(pixels.on(1));
  EXPECT_FALSE(pixels.on(2));
  EXPECT_FALSE(pixels.on(3)) << "what was not in the band does not come into it";
  EXPECT_EQ(pixels.inliers(), 2U);
  pixels.giveTo({Eigen::Vector3d::UnitZ(), 0.965});
  EXPECT_EQ(pixels.inliers(), 1U) << "a second plane takes of what the first one left";
  pixels.computeResiduals(kFloor, wide);
  EXPECT_EQ(pixels.inliers(), 3U) << "until they are held against a plane anew";
}

TEST(NoisyPixels, TellASurfaceAlongThePlaneFromOneAcross)
{
  constexpr float kSteepest = 0.35F;
  // Three rows of three columns: level; up a wall in the last row; with a hole in the last row.
  const NoisyPixels pixels = heldAgainst({{1.0F, 0.0F, -1.0F},
                                          {1.0F, 0.1F, -1.0F},
                                          {1.0F, 0.2F, -1.0F},
                                          {1.1F, 0.0F, -1.0F},
                                          {1.1F, 0.1F, -1.0F},
                                          {1.1F, 0.2F, -1.0F},
                                          {1.2F, 0.0F, -1.0F},
                                          {1.1F, 0.1F, -0.9F},
                                          kNoReturn},
                                         3);
  EXPECT_TRUE(pixels.liesFlat(0, kSteepest, 2.0F)) << "the first row has none above";
  EXPECT_TRUE(pixels.liesFlat(3, kSteepest, 2.0F)) << "along the floor in both rows";
  EXPECT_TRUE(pixels.liesFlat(6, kSteepest, 2.0F)) << "the last row has none below";
  EXPECT_FALSE(pixels.liesFlat(4, kSteepest, 2.0F)) << "the foot of the wall";
  EXPECT_FALSE(pixels.liesFlat(7, kSteepest, 2.0F)) << "the wall";
  EXPECT_TRUE(pixels.liesFlat(1, kSteepest, 2.0F)) << "a row before the wall";
  EXPECT_TRUE(pixels.liesFlat(5, kSteepest, 2.0F)) << "a hole says nothing";
}

TEST(NoisyPixels, AStepThatNoiseExplainsIsFlat)
{
  // 2 cm up in 3 cm along, 3 m away: the noise there is 1.4 cm times 1 / 3 across the floor.
  const std::vector<Eigen::Vector3f> points = {{2.83F, 0.0F, -1.0F}, {2.86F, 0.0F, -0.98F}};
  EXPECT_FALSE(heldAgainst(points).liesFlat(0, 0.35F, 0.0F));
  EXPECT_FALSE(heldAgainst(points).liesFlat(0, 0.35F, 1.0F)) << "5 mm of noise leave 15 mm in 36";
  EXPECT_TRUE(heldAgainst(points).liesFlat(0, 0.35F, 3.0F)) << "14 mm leave 6";
  EXPECT_FALSE(heldAgainst(points, 1, kBand, noNoise()).liesFlat(0, 0.35F, 3.0F));
}

std::vector<Eigen::Vector3f> lineOfPoints(int count)
{
  std::vector<Eigen::Vector3f> points;
  for (int k = 0; k < count; ++k) points.emplace_back(0.01F * static_cast<float>(k), 0.5F, -1.0F);
  return points;
}

TEST(NoisyPixels, PickTakesEverySoManyOfPlenty)
{
  const NoisyPixels pixels = heldAgainst(lineOfPoints(100));
  std::vector<std::uint32_t> picked;
  EXPECT_EQ(pixels.pick([](std::size_t) { return true; }, 10, picked), 10U);
  EXPECT_EQ(picked.size(), 10U);
  EXPECT_EQ(pixels.pick([](std::size_t) { return true; }, 1000, picked), 100U);
  EXPECT_EQ(picked.size(), 100U);
}

TEST(NoisyPixels, PickLeavesOutWhatIsNotAcceptedAndWhatIsNotInTheBand)
{
  std::vector<Eigen::Vector3f> points = lineOfPoints(6);
  points[2].z() = -0.5F;
  std::vector<std::uint32_t> picked;
  const std::size_t looked_at =
      heldAgainst(points).pick([](std::size_t k) { return k % 2 == 0; }, 100, picked);
  EXPECT_EQ(looked_at, 5U) << "those in the band";
  EXPECT_EQ(picked, (std::vector<std::uint32_t>{0, 4}));
}

TEST(NoisyPixels, OfNoneNothingIsPicked)
{
  std::vector<std::uint32_t> picked(3);
  EXPECT_EQ(heldAgainst({}).pick([](std::size_t) { return true; }, 0, picked), 0U);
  EXPECT_TRUE(picked.empty());
}

TEST(NoisyPixels, AHeavyPointIsTheSurerOne)
{
  // Two squares of points 2 cm apart, 1 m and 5 m away: the fit lies by the near ones.
  std::vector<Eigen::Vector3f> points;
  for (const float x : {-0.5F, 0.5F}) {
    for (const float y : {-0.5F, 0.5F}) {
      points.emplace_back(x, y, -1.0F);
      points.emplace_back(8.0F * x, 8.0F * y, -0.98F);
    }
  }
  const NoisyPixels pixels = heldAgainst(points);
  PlaneFit fit;
  for (std::size_t k = 0; k < points.size(); ++k) pixels.addTo(fit, k);
  EXPECT_EQ(fit.count(), 8U);
  const auto plane = fit.solve(Eigen::Vector3d::UnitZ());
  ASSERT_TRUE(plane);
  EXPECT_GT(plane->plane.distance, 0.996) << "1 of the near ones, 0.98 of the far ones";
}

TEST(NoisyPixels, NothingOfEarlierPointsIsLeft)
{
  NoisyPixels pixels = heldAgainst(lineOfPoints(10));
  ASSERT_EQ(pixels.inliers(), 10U);
  pixels.resize(2, 1);
  pixels.set(0, {1.0F, 0.0F, -0.5F});
  pixels.set(1, {1.0F, 0.0F, -1.0F});
  pixels.measure(SensorNoise());
  pixels.computeResiduals(kFloor, kBand);
  EXPECT_EQ(pixels.size(), 2U);
  EXPECT_EQ(pixels.inliers(), 1U);
}

}  // namespace
}  // namespace polygonal_perception::perception

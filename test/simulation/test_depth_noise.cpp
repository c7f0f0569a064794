#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "polygonal_perception/cameras/simulation/depth_noise.hpp"

namespace polygonal_perception::simulation {
namespace {

/// A bright wall that faces the camera.
RayImage wall(const PinholeCamera& camera, float depth)
{
  RayImage image;
  image.depth.assign(camera.size(), depth);
  image.cosine.assign(camera.size(), 1.0F);
  image.reflectance.assign(camera.size(), 0.8F);
  image.surface.assign(camera.size(), Surface::kObstacle);
  return image;
}

DepthNoise::Parameters onlySigma()
{
  DepthNoise::Parameters p = DepthNoise::Parameters::none();
  const DepthNoise::Parameters defaults;
  p.sigma_base = defaults.sigma_base;
  p.sigma_quadratic = defaults.sigma_quadratic;
  p.correlation = defaults.correlation;
  return p;
}

std::size_t lost(const std::vector<float>& depth)
{
  std::size_t count = 0;
  for (const float z : depth) count += static_cast<std::size_t>(std::isnan(z));
  return count;
}

TEST(DepthNoise, NoneLeavesTheDepthAsItIs)
{
  const PinholeCamera camera;
  RayImage image = wall(camera, 2.345F);
  image.depth[7] = NAN;
  std::vector<float> depth;
  DepthNoise(DepthNoise::Parameters::none(), 1).apply(camera, image, 0, depth);
  EXPECT_TRUE(std::isnan(depth[7]));
  depth[7] = image.depth[7] = 0.0F;
  EXPECT_EQ(depth, image.depth);
}

TEST(DepthNoise, SpreadFollowsTheFormula)
{
  const PinholeCamera camera;
  for (const double z : {1.0, 2.0, 3.0, 5.0}) {
    DepthNoise noise(onlySigma(), 5);
    double sum = 0.0;
    double squares = 0.0;
    double next = 0.0;
    double far = 0.0;
    const int frames = 4;
    std::vector<float> depth;
    for (int frame = 0; frame < frames; ++frame) {
      noise.apply(camera, wall(camera, static_cast<float>(z)), static_cast<std::uint32_t>(frame), depth);
      for (std::size_t i = 0; i + 40 < depth.size(); ++i) {
        const double error = depth[i] - z;
        sum += error;
        squares += error * error;
        next += error * (depth[i + 1] - z);
        far += error * (depth[i + 40] - z);
      }
    }
    const double count = static_cast<double>(frames) * static_cast<double>(depth.size() - 40);
    const double sigma = std::sqrt(squares / count);
    const double expected = 0.0012 + 0.0019 * (z - 0.4) * (z - 0.4);
    EXPECT_NEAR(sigma, expected, 0.03 * expected) << "at " << z << " m";
    EXPECT_LT(std::abs(sum / count), 0.03 * expected) << "at " << z << " m";
    EXPECT_GT(next / squares, 0.8) << "neighbours are alike";
    EXPECT_LT(std::abs(far / squares), 0.05) << "distant pixels are not";
  }
}

TEST(DepthNoise, StepsAreThoseOfTheDisparity)
{
  DepthNoise::Parameters p = onlySigma();
  p.disparity_step = 0.125;
  const PinholeCamera camera;
  std::vector<float> depth;
  DepthNoise(p, 3).apply(camera, wall(camera, 3.0F), 0, depth);
  for (const float z : depth) {
    const double steps = 0.075 * 570.3 / z / 0.125;
    ASSERT_NEAR(steps, std::round(steps), 1e-3) << z;
  }
}

TEST(DepthNoise, ForegroundCastsAShadowToItsLeftAsWideAsTheDisparity)
{
  DepthNoise::Parameters p = DepthNoise::Parameters::none();
  p.shadows = true;
  const PinholeCamera camera;
  RayImage image = wall(camera, 3.0F);
  for (std::size_t v = 0; v < camera.height; ++v) {
    for (std::size_t u = 300; u < 400; ++u) image.depth[v * camera.width + u] = 1.0F;
  }
  std::vector<float> depth;
  DepthNoise(p, 1).apply(camera, image, 0, depth);
  // fx b (1/1 - 1/3) = 28.5 px.
  std::size_t dark = 0;
  for (std::size_t u = 0; u < camera.width; ++u) {
    if (!std::isnan(depth[u])) continue;
    ++dark;
    EXPECT_GE(u, 270U);
    EXPECT_LT(u, 300U);
  }
  EXPECT_NEAR(static_cast<double>(dark), 28.5, 1.5);
}

TEST(DepthNoise, FlatDarkNearAndFarSurfacesAreLost)
{
  const PinholeCamera camera = PinholeCamera::ofSize(160, 120);
  const auto lostOn = [&](float z, float cosine, float reflectance) {
    RayImage image = wall(camera, z);
    image.cosine.assign(camera.size(), cosine);
    image.reflectance.assign(camera.size(), reflectance);
    DepthNoise::Parameters p;
    p.blobs = 0.0;
    p.dead_columns = 0;
    std::vector<float> depth;
    DepthNoise(p, 1).apply(camera, image, 0, depth);
    return static_cast<double>(lost(depth)) / static_cast<double>(camera.size());
  };
  EXPECT_LT(lostOn(2.0F, 1.0F, 0.6F), 0.01);
  EXPECT_GT(lostOn(2.0F, 0.03F, 0.6F), 0.95) << "grazing";
  EXPECT_GT(lostOn(3.0F, 1.0F, 0.03F), 0.95) << "dark and far";
  EXPECT_LT(lostOn(1.0F, 1.0F, 0.03F), 0.01) << "dark, but near";
  EXPECT_GT(lostOn(0.3F, 1.0F, 0.6F), 0.99) << "too near";
  EXPECT_GT(lostOn(9.0F, 1.0F, 0.9F), 0.99) << "too far";
}

TEST(DepthNoise, EdgesFrayAndFlatPartsStay)
{
  DepthNoise::Parameters p = DepthNoise::Parameters::none();
  p.edge_loss = 0.5;
  const PinholeCamera camera;
  RayImage image = wall(camera, 3.0F);
  for (std::size_t v = 0; v < camera.height; ++v) {
    for (std::size_t u = 300; u < camera.width; ++u) image.depth[v * camera.width + u] = 1.0F;
  }
  std::vector<float> depth;
  DepthNoise(p, 1).apply(camera, image, 0, depth);
  std::size_t gone = 0;
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (!std::isnan(depth[i])) continue;
    ++gone;
    EXPECT_TRUE(i % 640 >= 298 && i % 640 < 302) << i % 640;
  }
  EXPECT_NEAR(static_cast<double>(gone), 960.0, 200.0) << "half of four columns, in patches of 3 x 3";
}

TEST(DepthNoise, RightEndIsBlind)
{
  DepthNoise::Parameters p = DepthNoise::Parameters::none();
  p.dead_columns = 8;
  const PinholeCamera camera = PinholeCamera::ofSize(320, 240);
  std::vector<float> depth;
  DepthNoise(p, 1).apply(camera, wall(camera, 2.0F), 0, depth);
  for (std::size_t i = 0; i < depth.size(); ++i) {
    ASSERT_EQ(std::isnan(depth[i]), i % 320 >= 316) << "four columns of half the size, pixel " << i;
  }
}

TEST(DepthNoise, AFrameHasTheSameNoiseWhenItIsAskedForAgain)
{
  const PinholeCamera camera = PinholeCamera::ofSize(160, 120);
  const RayImage image = wall(camera, 2.0F);
  const auto sixth = [&](std::uint64_t seed, bool after_others) {
    DepthNoise noise(DepthNoise::Parameters{}, seed);
    std::vector<float> depth;
    if (after_others) {
      for (std::uint32_t frame : {9U, 2U, 7U}) noise.apply(camera, image, frame, depth);
    }
    noise.apply(camera, image, 6, depth);
    for (float& z : depth) {
      if (std::isnan(z)) z = 0.0F;
    }
    return depth;
  };
  EXPECT_EQ(sixth(1, false), sixth(1, true));
  EXPECT_NE(sixth(1, false), sixth(2, false));
}

TEST(DepthNoise, AParameterOutOfRangeIsRefusedByName)
{
  DepthNoise::Parameters p;
  p.edge_loss = 1.5;
  try {
    const DepthNoise noise(p, 1);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& e) {
    EXPECT_NE(std::string(e.what()).find("edge_loss"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace polygonal_perception::simulation

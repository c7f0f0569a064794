#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "perception/planes/region_growing.hpp"
#include "polygonal_perception/geometry/angle.hpp"
#include "support/plane_scene.hpp"

namespace polygonal_perception::perception {
namespace {

constexpr double kDegree = 0.017453292519943295;

/// What grows in a scene.
struct Grown
{
  explicit Grown(const test::PlaneScene& scene, const PlaneExtractionParameters& parameters = {})
  {
    SampleGrid grid{SampleGrid::Parameters{}};
    grid.update(scene.view());
    samples.take(grid, parameters);
    RegionGrowing().grow(samples, parameters, segments);
  }
  Grown(NoisySamples by_hand, const PlaneExtractionParameters& parameters) : samples(std::move(by_hand))
  {
    RegionGrowing().grow(samples, parameters, segments);
  }

  /// Of the segments, the largest first.
  std::vector<std::size_t> sizes() const
  {
    std::vector<std::size_t> sizes;
    for (const PlaneSegment& segment : segments.all) sizes.push_back(segment.points.count());
    std::sort(sizes.rbegin(), sizes.rend());
    return sizes;
  }

  NoisySamples samples;
  PlaneSegments segments;
};

/// A wall that faces the camera, its left half nearer by a step.
test::PlaneScene steppedWall(double distance, double step, double sigma)
{
  test::PlaneScene scene(160, 120, 142.5, sigma);
  scene.add({-Eigen::Vector3d::UnitZ(), distance}, [](const Eigen::Vector3d& p) { return p.x() >= 0.0; });
  scene.add({-Eigen::Vector3d::UnitZ(), distance - step},
            [](const Eigen::Vector3d& p) { return p.x() < 0.0; });
  return scene;
}

/// Samples on a plane that faces the camera more or less, a decimetre apart; no noise.
NoisySamples patch(std::uint32_t columns, std::uint32_t rows, const geometry::Plane& plane)
{
  NoisySamples samples;
  samples.columns = columns;
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < columns; ++i) {
      NoisySample sample;
      const Eigen::Vector3d above(0.1 * i, 0.1 * j, 1.0);
      sample.point = (above - plane.height(above) * plane.normal).cast<float>();
      sample.normal = plane.normal.cast<float>();
      sample.range = sample.point.norm();
      sample.model_variance = 1e-6F;
      sample.has_point = sample.has_normal = true;
      sample.begins_row = i == 0;
      sample.ends_row = i + 1 == columns;
      samples.all.push_back(sample);
    }
  }
  return samples;
}

TEST(RegionGrowing, ABareFloorIsOneSegment)
{
  const geometry::Plane floor = test::floorSeenFrom(1.0, 0.9);
  test::PlaneScene scene;
  scene.add(floor);
  const Grown grown(scene);
  ASSERT_EQ(grown.sizes(), std::vector<std::size_t>{32 * 32}) << "all samples in one segment";
  const PlaneFit::Result& fit = grown.segments.all[0].fit;
  EXPECT_NEAR(fit.plane.distance, 1.0, 1e-4);
  EXPECT_LT(geometry::angleBetween(fit.plane.normal, floor.normal), 1e-4)
      << "seen " << fit.plane.normal.transpose() << ", expected " << floor.normal.transpose();
}

TEST(RegionGrowing, AWallAndACeilingGrowAsAFloorDoes)
{
  for (const geometry::Plane& plane :
       {geometry::Plane{-Eigen::Vector3d::UnitZ(), 1.0},
        geometry::Plane{Eigen::Vector3d(0.0, std::sqrt(0.5), -std::sqrt(0.5)), 1.0},
        geometry::Plane{Eigen::Vector3d(std::sqrt(0.5), 0.0, -std::sqrt(0.5)), 1.0}}) {
    test::PlaneScene scene;
    scene.add(plane);
    const Grown grown(scene);
    ASSERT_EQ(grown.sizes().size(), 1U) << "normal " << plane.normal.transpose();
    EXPECT_GT(grown.sizes()[0], 1000U) << "normal " << plane.normal.transpose();
  }
}

TEST(RegionGrowing, AStepOf3CentimetresParts)
{
  const auto sizes = Grown(steppedWall(1.0, 0.03, 0.0019)).sizes();
  ASSERT_GE(sizes.size(), 2U) << "two halves";
  EXPECT_GT(sizes[0], 400U);
  EXPECT_GT(sizes[1], 400U);
}

TEST(RegionGrowing, ASkirtingBoardsStepOf15MillimetresParts)
{
  // Within the model's error, which a lens may bend a plane by, but not from a sample to the next.
  const Grown grown(steppedWall(1.0, 0.015, 0.0019));
  const auto sizes = grown.sizes();
  ASSERT_GE(sizes.size(), 2U) << "two halves";
  EXPECT_GT(sizes[0], 400U);
  EXPECT_GT(sizes[1], 400U);
}

TEST(RegionGrowing, NoSegmentLiesOnBothSidesOfAStepThatNeighboursCannotTell)
{
  // 2 m away two neighbours err by 6 mm each, and 3 cm between them may be noise. What has grown so far knows
  // better.
  const Grown grown(steppedWall(2.0, 0.03, 0.006));
  const auto sizes = grown.sizes();
  ASSERT_GE(sizes.size(), 2U) << "two halves";
  EXPECT_GT(sizes[0], 350U);
  EXPECT_GT(sizes[1], 350U);
  for (const PlaneSegment& segment : grown.segments.all) {
    if (segment.points.count() < 350) continue;
    const double nearest =
        std::min(std::abs(segment.fit.plane.distance - 2.0), std::abs(segment.fit.plane.distance - 1.97));
    EXPECT_LT(nearest, 0.006) << "seen at " << segment.fit.plane.distance << " m, expected at 1.97 or 2";
  }
}

TEST(RegionGrowing, ARampOf8DegreesDoesNotRunIntoTheFloor)
{
  const geometry::Plane floor = test::floorSeenFrom(0.8, 0.6);
  const Eigen::Vector3d ahead(0.0, floor.normal.z(), -floor.normal.y());
  const Eigen::Vector3d up = std::cos(8 * kDegree) * floor.normal - std::sin(8 * kDegree) * ahead;
  const Eigen::Vector3d foot = 1.2 * ahead - 0.8 * floor.normal;
  test::PlaneScene scene(160, 120, 142.5, 0.002);
  scene.add(floor, [&](const Eigen::Vector3d& p) { return ahead.dot(p) < 1.2; });
  scene.add({up, -up.dot(foot)}, [&](const Eigen::Vector3d& p) { return ahead.dot(p) >= 1.2; });
  const Grown grown(scene);
  ASSERT_GE(grown.segments.all.size(), 2U);
  for (const PlaneSegment& segment : grown.segments.all) {
    if (segment.points.count() < 100) continue;
    const double angle = geometry::angleBetween(segment.fit.plane.normal, floor.normal) / kDegree;
    EXPECT_LT(std::min(angle, std::abs(angle - 8.0)), 1.0)
        << segment.points.count() << " samples at " << angle << " degrees to the floor, expected 0 or 8";
  }
}

TEST(RegionGrowing, TheSegmentsCountTheSamplesThatNameThem)
{
  const geometry::Plane floor = test::floorSeenFrom(1.0, 0.7);
  test::PlaneScene scene(160, 120, 142.5, 0.004);
  scene.add(floor);
  scene.add(test::raised(floor, 0.3), [](const Eigen::Vector3d& p) { return p.x() < -0.1; });
  const Grown grown(scene);
  ASSERT_GE(grown.segments.all.size(), 2U);
  const std::vector<int>& of = grown.segments.of_sample;
  ASSERT_EQ(of.size(), 32U * 32U);
  for (std::size_t s = 0; s < grown.segments.all.size(); ++s) {
    EXPECT_EQ(std::count(of.begin(), of.end(), static_cast<int>(s)),
              static_cast<std::ptrdiff_t>(grown.segments.all[s].points.count()))
        << "segment " << s;
  }
  EXPECT_LT(*std::max_element(of.begin(), of.end()), static_cast<int>(grown.segments.all.size()));
}

TEST(RegionGrowing, FewerThanTheLeastSamplesAreNoPlane)
{
  const PlaneExtractionParameters parameters;  // 6 samples
  const geometry::Plane wall{-Eigen::Vector3d::UnitZ(), 1.0};
  EXPECT_EQ(Grown(patch(3, 2, wall), parameters).sizes(), std::vector<std::size_t>{6});
  NoisySamples five = patch(3, 2, wall);
  five.all[5].has_normal = false;
  const Grown grown(five, parameters);
  EXPECT_TRUE(grown.segments.all.empty());
  EXPECT_EQ(grown.segments.of_sample, std::vector<int>(6, PlaneSegments::kNone)) << "nor do they name one";
}

TEST(RegionGrowing, SamplesOfOneRowAreNoPlane)
{
  // However many: they lie on a line, and on a plane through the camera.
  EXPECT_TRUE(Grown(patch(20, 1, {-Eigen::Vector3d::UnitZ(), 1.0}), {}).segments.all.empty());
}

TEST(RegionGrowing, APlaneThroughTheCameraIsNone)
{
  // 10 x 3 samples about 1 m away: what a plane 3 mm off the camera would show is seen at 0.17 degrees.
  const auto seenFrom = [](double distance) {
    NoisySamples samples = patch(10, 3, {Eigen::Vector3d::UnitY(), 0.0});
    for (std::size_t k = 0; k < samples.all.size(); ++k) {
      samples.all[k].point = Eigen::Vector3f(0.1F * static_cast<float>(k % 10), -static_cast<float>(distance),
                                             0.8F + 0.2F * static_cast<float>(k / 10));
      samples.all[k].range = samples.all[k].point.norm();
    }
    return samples;
  };
  EXPECT_TRUE(Grown(seenFrom(0.003), {}).segments.all.empty());
  EXPECT_EQ(Grown(seenFrom(0.03), {}).sizes(), std::vector<std::size_t>{30});
}

TEST(RegionGrowing, ASampleWithAnotherNormalIsLeftOut)
{
  const PlaneExtractionParameters parameters;
  NoisySamples samples = patch(4, 4, {-Eigen::Vector3d::UnitZ(), 1.0});
  samples.all[5].normal = Eigen::Vector3f(std::sin(0.5F), 0.0F, -std::cos(0.5F));  // 29 degrees, cosine 0.88
  Grown grown(samples, parameters);
  EXPECT_EQ(grown.sizes(), std::vector<std::size_t>{15});
  EXPECT_EQ(grown.segments.of_sample[5], PlaneSegments::kNone);
  samples.all[5].normal = Eigen::Vector3f(std::sin(0.09F), 0.0F, -std::cos(0.09F));  // 5 degrees
  EXPECT_EQ(Grown(samples, parameters).sizes(), std::vector<std::size_t>{16});
}

TEST(RegionGrowing, AWideClusterDistanceDoesNotLetAStepThrough)
{
  // Neighbours alone would let 20 cm pass.
  PlaneExtractionParameters parameters;
  parameters.cluster_distance = 0.5;
  const auto sizes = Grown(steppedWall(1.0, 0.2, 0.0019), parameters).sizes();
  ASSERT_GE(sizes.size(), 2U) << "two halves";
  EXPECT_GT(sizes[1], 400U);
}

TEST(RegionGrowing, ATinyClusterDistanceIsWidenedByTheNoise)
{
  PlaneExtractionParameters parameters;
  parameters.cluster_distance = 0.0;
  test::PlaneScene scene(160, 120, 142.5, 0.0019);
  scene.add({-Eigen::Vector3d::UnitZ(), 1.0});
  const auto with_noise = Grown(scene, parameters).sizes();
  ASSERT_FALSE(with_noise.empty());
  EXPECT_GT(with_noise[0], 900U);
  parameters.cluster_sigmas = 0.1;
  const auto without = Grown(scene, parameters).sizes();
  EXPECT_LT(without.empty() ? 0U : without[0], 500U) << "neighbours differ by more than a tenth of the noise";
}

TEST(RegionGrowing, StartsWhereTheSurfaceIsFlat)
{
  // The uppermost samples of a wall lie 1.5 cm nearer, such as on a lintel: the normals of the first two rows
  // lean by 28 and 15 degrees. Whoever starts there finds a plane of these two rows.
  test::PlaneScene scene;
  scene.add({-Eigen::Vector3d::UnitZ(), 1.0});
  for (std::size_t k = 0; k < 2 * 160; ++k) scene.depth()[k] = 0.985F;
  const Grown grown(scene);
  EXPECT_EQ(grown.sizes(), std::vector<std::size_t>{32 * 31}) << "all but the first row";
  EXPECT_EQ(grown.segments.of_sample[0], PlaneSegments::kNone);
  EXPECT_EQ(grown.segments.of_sample[32], 0);
}

TEST(RegionGrowing, AFrameWithoutReturnsHasNone)
{
  const Grown grown{test::PlaneScene()};
  EXPECT_TRUE(grown.segments.all.empty());
  EXPECT_EQ(grown.segments.of_sample.size(), 32U * 32U);
}

TEST(RegionGrowing, NothingOfTheLastFrameIsLeft)
{
  const PlaneExtractionParameters parameters;
  RegionGrowing growing;
  PlaneSegments segments;
  const geometry::Plane wall{-Eigen::Vector3d::UnitZ(), 1.0};
  growing.grow(patch(8, 8, wall), parameters, segments);
  ASSERT_EQ(segments.all.size(), 1U);
  growing.grow(patch(3, 3, wall), parameters, segments);
  ASSERT_EQ(segments.all.size(), 1U);
  EXPECT_EQ(segments.all[0].points.count(), 9U);
  EXPECT_EQ(segments.of_sample, std::vector<int>(9, 0));
  growing.grow(NoisySamples{}, parameters, segments);
  EXPECT_TRUE(segments.all.empty());
  EXPECT_TRUE(segments.of_sample.empty());
}

}  // namespace
}  // namespace polygonal_perception::perception

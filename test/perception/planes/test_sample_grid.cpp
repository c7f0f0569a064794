#include <gtest/gtest.h>

#include <limits>

#include "polygonal_perception/perception/planes/sample_grid.hpp"
#include "support/plane_scene.hpp"

namespace polygonal_perception::perception {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

TEST(SampleGrid, TakesBorderPixels)
{
  test::PlaneScene scene(640, 480, 570.3);
  scene.add(test::floorSeenFrom(0.8, 0.5));
  SampleGrid grid{SampleGrid::Parameters{}};
  grid.update(scene.view());
  ASSERT_EQ(grid.samplesX(), 32);
  ASSERT_EQ(grid.samplesY(), 32);
  EXPECT_EQ(grid.at(0, 31).u, 0);
  EXPECT_EQ(grid.at(0, 31).v, 479);
  EXPECT_EQ(grid.at(31, 31).u, 639);
}

TEST(SampleGrid, NormalsOfAPlaneAreItsNormal)
{
  const geometry::Plane floor = test::floorSeenFrom(0.8, 0.7, 0.1);
  test::PlaneScene scene;
  scene.add(floor);
  SampleGrid grid{SampleGrid::Parameters{}};
  grid.update(scene.view());
  for (const Sample& sample : grid.samples()) {
    ASSERT_TRUE(sample.has_normal) << "at " << sample.u << ", " << sample.v;
    EXPECT_GT(sample.normal.dot(floor.normal.cast<float>()), 0.9999F)
        << "at " << sample.u << ", " << sample.v;
  }
}

TEST(SampleGrid, NormalsDoNotDependOnTheFrameOfThePoints)
{
  // A level floor 1 m below a camera that looks along x in a body frame: rows run down the image, columns to
  // the right.
  std::vector<Eigen::Vector3f> points;
  for (int v = 0; v < 8; ++v) {
    for (int u = 0; u < 8; ++u) points.emplace_back(5.0F - 0.5F * v, 2.0F - 0.5F * u, -1.0F);
  }
  struct Xyz
  {
    float x, y, z;
  };
  std::vector<Xyz> memory;
  for (const auto& p : points) memory.push_back({p.x(), p.y(), p.z()});
  SampleGrid grid({8, 8});
  grid.update(PointView::points(memory.data(), 8, 8));
  for (const Sample& sample : grid.samples()) {
    ASSERT_TRUE(sample.has_normal);
    EXPECT_TRUE(sample.normal.isApprox(Eigen::Vector3f::UnitZ(), 1e-6F)) << sample.normal.transpose();
  }
}

TEST(SampleGrid, APixelWithoutReturnGivesWayToOneCloseBy)
{
  test::PlaneScene scene(640, 480, 570.3);
  scene.add(test::floorSeenFrom(0.8, 0.7));
  SampleGrid grid{SampleGrid::Parameters{}};
  grid.update(scene.view());
  const Sample before = grid.at(10, 20);
  scene.depth()[before.v * 640U + before.u] = kNaN;
  grid.update(scene.view());
  const Sample after = grid.at(10, 20);
  ASSERT_TRUE(after.has_point);
  EXPECT_EQ(std::abs(after.u - before.u) + std::abs(after.v - before.v), 1);
}

TEST(SampleGrid, NothingOfTheLastFrameIsLeft)
{
  test::PlaneScene scene;
  scene.add(test::floorSeenFrom(0.8, 0.7));
  SampleGrid grid{SampleGrid::Parameters{}};
  grid.update(scene.view());
  scene.depth().assign(scene.depth().size(), kNaN);
  grid.update(scene.view());
  for (const Sample& sample : grid.samples()) {
    ASSERT_FALSE(sample.has_point);
    ASSERT_FALSE(sample.has_normal);
  }
}

TEST(SampleGrid, ALoneRowHasNoNormals)
{
  // Above and below the row there is nothing: no pair of points down the image.
  test::PlaneScene scene(32, 32, 30.0);
  scene.add(test::floorSeenFrom(0.8, 0.7));
  for (std::size_t k = 0; k < scene.depth().size(); ++k) {
    if (k / 32 != 16) scene.depth()[k] = kNaN;
  }
  SampleGrid grid{SampleGrid::Parameters{}};
  grid.update(scene.view());
  EXPECT_TRUE(grid.at(5, 16).has_point);
  EXPECT_FALSE(grid.at(5, 16).has_normal);
}

TEST(SampleGrid, BesideADepthEdgeTheNormalIsThatOfTheNearSide)
{
  // A box's top, 0.4 m over the floor: across its edge the central difference would tilt the normal.
  const geometry::Plane floor = test::floorSeenFrom(1.0, 0.8);
  const auto left = [](const Eigen::Vector3d& p) { return p.x() < 0.0; };
  test::PlaneScene scene(640, 480, 570.3);
  scene.add(floor);
  scene.add(test::raised(floor, 0.4), left);
  SampleGrid grid{SampleGrid::Parameters{}};
  grid.update(scene.view());
  EXPECT_GT(grid.at(15, 20).normal.dot(floor.normal.cast<float>()), 0.999F)
      << grid.at(15, 20).normal.transpose();
  EXPECT_GT(grid.at(16, 20).normal.dot(floor.normal.cast<float>()), 0.999F)
      << grid.at(16, 20).normal.transpose();
}

TEST(SampleGrid, AnImageSmallerThanTheGridIsSampledPixelByPixel)
{
  test::PlaneScene scene(8, 6, 8.0);
  scene.add(test::floorSeenFrom(0.8, 0.9));
  SampleGrid grid{SampleGrid::Parameters{}};
  grid.update(scene.view());
  EXPECT_EQ(grid.samplesX(), 8);
  EXPECT_EQ(grid.samplesY(), 6);
}

}  // namespace
}  // namespace polygonal_perception::perception

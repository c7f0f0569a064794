#include <gtest/gtest.h>

#include <algorithm>

#include "perception/floor/segmentation.hpp"
#include "support/plane_scene.hpp"

namespace polygonal_perception::perception {
namespace {

const float kUpright = 0.7F;

std::vector<std::uint32_t> sizesOf(const test::PlaneScene& scene, const geometry::Plane& floor,
                                   float cluster_distance = 0.01F)
{
  SampleGrid grid{SampleGrid::Parameters{}};
  grid.update(scene.view());
  Segmentation segmentation;
  segmentation.segment(grid, floor.normal.cast<float>(), kUpright, cluster_distance);
  std::vector<std::uint32_t> sizes;
  for (const auto& segment : segmentation.segments()) sizes.push_back(segment.size);
  std::sort(sizes.rbegin(), sizes.rend());
  return sizes;
}

TEST(Segmentation, ABareFloorIsOneSegment)
{
  const geometry::Plane floor = test::floorSeenFrom(1.0, 0.9);
  test::PlaneScene scene;
  scene.add(floor);
  EXPECT_EQ(sizesOf(scene, floor), std::vector<std::uint32_t>{32 * 32});
}

TEST(Segmentation, AStepOf20CentimetresParts)
{
  const geometry::Plane floor = test::floorSeenFrom(1.0, 0.9);
  test::PlaneScene scene;
  scene.add(floor);
  scene.add(test::raised(floor, 0.2), [](const Eigen::Vector3d& p) { return p.x() < 0.0; });
  const auto sizes = sizesOf(scene, floor);
  ASSERT_GE(sizes.size(), 2U);
  EXPECT_GT(sizes[0], 400U);
  EXPECT_GT(sizes[1], 400U);
}

TEST(Segmentation, AWallIsPruned)
{
  test::PlaneScene scene;
  scene.add({-Eigen::Vector3d::UnitZ(), 1.0});
  EXPECT_TRUE(sizesOf(scene, test::floorSeenFrom(1.0, 0.0)).empty());
}

TEST(Segmentation, EverySampleIsInTheSegmentThatListsIt)
{
  const geometry::Plane floor = test::floorSeenFrom(1.0, 0.7);
  test::PlaneScene scene(160, 120, 142.5, 0.003);
  scene.add(floor);
  SampleGrid grid{SampleGrid::Parameters{}};
  grid.update(scene.view());
  Segmentation segmentation;
  segmentation.segment(grid, floor.normal.cast<float>(), kUpright, 0.01F);
  std::size_t listed = 0;
  for (std::size_t s = 0; s < segmentation.segments().size(); ++s) {
    const auto& segment = segmentation.segments()[s];
    for (std::uint32_t k = segment.first; k < segment.first + segment.size; ++k) {
      EXPECT_EQ(segmentation.segmentOf()[segmentation.members()[k]], static_cast<int>(s));
      ++listed;
    }
  }
  const auto& of = segmentation.segmentOf();
  EXPECT_EQ(listed, static_cast<std::size_t>(
                        std::count_if(of.begin(), of.end(), [](int s) { return s != Segmentation::kNone; })));
}

}  // namespace
}  // namespace polygonal_perception::perception

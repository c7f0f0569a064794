#include <gtest/gtest.h>

#include <Eigen/StdVector>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <opencv2/core.hpp>

#include "polygonal_perception/perception/pipeline.hpp"
#include "support/allocation_counter.hpp"
#include "support/box_scene.hpp"

namespace polygonal_perception::perception {
namespace {

/// Frames of boxes that stand elsewhere in each, in every layout.
class BoxFrames
{
public:
  BoxFrames()
  {
    test::BoxScene scene;
    rays_ = scene.rays();
    for (int k = 0; k < 6; ++k) {
      scene.boxes = {{Eigen::Vector3d(1.5 + 0.2 * k, -0.6, 0.0), Eigen::Vector3d(1.9 + 0.2 * k, -0.2, 0.4)},
                     {Eigen::Vector3d(2.0, 0.3 + 0.1 * k, 0.0), Eigen::Vector3d(2.3, 0.8 + 0.1 * k, 1.0)}};
      metres_.push_back(scene.depth());
      millimetres_.emplace_back();
      clouds_.emplace_back();
      for (const float z : metres_.back()) {
        millimetres_.back().push_back(std::isnan(z) ? 0
                                                    : static_cast<std::uint16_t>(std::lround(1000.0F * z)));
      }
      const PointView points = PointView::depth(metres_.back().data(), 4 * std::size_t{width()}, rays_);
      for (std::uint32_t v = 0; v < points.height(); ++v) {
        for (std::uint32_t u = 0; u < points.width(); ++u)
          clouds_.back().emplace_back(points.point(u, v).homogeneous());
      }
    }
  }

  std::size_t size() const { return metres_.size(); }

  PointView view(PointLayout layout, std::size_t k) const
  {
    if (layout == PointLayout::kDepthUnits) {
      return PointView::depth(millimetres_[k].data(), 2 * std::size_t{width()}, rays_);
    }
    if (layout == PointLayout::kDepthMetres) {
      return PointView::depth(metres_[k].data(), 4 * std::size_t{width()}, rays_);
    }
    PointView::CloudStrides strides;
    strides.point_step = sizeof(Eigen::Vector4f);
    strides.row_step = strides.point_step * width();
    return PointView::cloud(clouds_[k].data(), width(), static_cast<std::uint32_t>(rays_.row_slope.size()),
                            strides);
  }

private:
  std::uint32_t width() const { return static_cast<std::uint32_t>(rays_.column_slope.size()); }

  PinholeRays rays_;
  std::vector<std::vector<std::uint16_t>> millimetres_;
  std::vector<std::vector<float>> metres_;
  std::vector<std::vector<Eigen::Vector4f, Eigen::aligned_allocator<Eigen::Vector4f>>> clouds_;
};

class Allocations : public testing::TestWithParam<PointLayout>
{
protected:
  void SetUp() override
  {
    if (!test::AllocationCounter::available()) GTEST_SKIP() << "a sanitizer counts allocations itself";
  }

  /// The allocations of each of two rounds of work over all the frames: while it warms up and after that.
  template <class Work>
  std::pair<std::size_t, std::size_t> count(Work&& work) const
  {
    std::size_t counts[2] = {};
    for (std::size_t& round : counts) {
      for (std::size_t k = 0; k < frames_.size(); ++k) {
        const test::AllocationCounter counter;
        work(frames_.view(GetParam(), k));
        round += counter.count();
      }
    }
    return {counts[0], counts[1]};
  }

  BoxFrames frames_;
};

TEST(AllocationCounter, SeesEveryWayToAllocate)
{
  if (!test::AllocationCounter::available()) GTEST_SKIP() << "a sanitizer counts allocations itself";
  const test::AllocationCounter counter;
  const auto by_new = std::make_unique<int>(1);
  const std::unique_ptr<void, decltype(&std::free)> by_calloc(std::calloc(1, 16), std::free);
  const Eigen::VectorXd by_eigen = Eigen::VectorXd::Zero(100);
  const cv::Mat by_opencv(10, 10, CV_8UC1);
  EXPECT_GE(counter.count(), 4U);
  EXPECT_NE(by_new.get(), by_calloc.get());
  EXPECT_NE(static_cast<const void*>(by_eigen.data()), static_cast<const void*>(by_opencv.data));
}

TEST_P(Allocations, OfThePipelineAreNoneOnceItIsWarm)
{
  Pipeline::Parameters parameters;
  parameters.ground.max_slope = 0.2;
  parameters.projection.height_sigmas = 3.0;
  Pipeline pipeline{parameters};
  Frame frame;
  const auto [warming, warm] = count([&](const PointView& points) {
    frame.points = points;
    frame.stamp += 0.03;
    pipeline.process(frame, {Product::kPolygons, Product::kLookedThrough, Product::kScan});
    ASSERT_EQ(pipeline.result().floor.status, FloorStatus::kFound);
    ASSERT_FALSE(pipeline.result().polygons.rings.empty());
  });
  EXPECT_GT(warming, 0U);
  EXPECT_EQ(warm, 0U);
}

TEST_P(Allocations, OfThePlanesAreNoneOnceTheyAreWarm)
{
  Pipeline pipeline{Pipeline::Parameters{}};
  Frame frame;
  const auto work = [&](const PointView& points) {
    frame.points = points;
    frame.stamp += 0.03;
    ASSERT_FALSE(pipeline.process(frame, Product::kPlanes).planes.vertices.empty());
  };
  const std::size_t warming = count(work).first;
  // The jump back from the last frame to the first has other planes in common than those that follow one another.
  const std::size_t warm = count(work).second;
  EXPECT_GT(warming, 0U);
  EXPECT_EQ(warm, 0U);
}

TEST_P(Allocations, OfThePipelineAreNoneWhereThereIsNoFloor)
{
  Pipeline::Parameters parameters;
  parameters.detector.selection.min_camera_height = 2.0;
  Pipeline pipeline(parameters);
  Frame frame;
  const auto [warming, warm] = count([&](const PointView& points) {
    frame.points = points;
    frame.stamp += 0.03;
    pipeline.process(frame);
    ASSERT_EQ(pipeline.result().floor.status, FloorStatus::kNotFound);
  });
  EXPECT_GT(warming, 0U);
  EXPECT_EQ(warm, 0U);
}

TEST_P(Allocations, OfTheProjectionAreNoneWhenPointsAreCountedOrCollected)
{
  Projection::Parameters parameters;
  parameters.min_points_per_cell = 3;
  Projection projection(parameters);
  occupancy::BinaryGrid grid{occupancy::GridGeometry(occupancy::GridParameters{})};
  std::vector<Eigen::Vector3f> standing;
  const Eigen::Isometry3d to_floor = test::BoxScene().toFloorFrame();
  const auto [warming, warm] = count([&](const PointView& points) {
    projection.project(points, to_floor, grid);
    projection.collect(points, to_floor, grid.geometry(), standing);
    ASSERT_FALSE(standing.empty());
  });
  EXPECT_GT(warming, 0U);
  EXPECT_EQ(warm, 0U);
}

INSTANTIATE_TEST_SUITE_P(EveryLayout, Allocations,
                         testing::Values(PointLayout::kCloud, PointLayout::kDepthUnits,
                                         PointLayout::kDepthMetres));

}  // namespace
}  // namespace polygonal_perception::perception

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "polygonal_perception/perception/pipeline.hpp"
#include "support/box_scene.hpp"

namespace polygonal_perception::perception {
namespace {

/// A box of 0.4 m x 0.4 m x 0.3 m, 1.5 m ahead and a little to the left, on the floor before the camera.
class PipelineTest : public ::testing::Test
{
protected:
  PipelineTest()
  {
    scene_.boxes = {Eigen::AlignedBox3d(Eigen::Vector3d(1.5, 0.1, 0.0), Eigen::Vector3d(1.9, 0.5, 0.3))};
    look();
  }

  void look()
  {
    depth_ = scene_.depth();
    rays_ = scene_.rays();
  }

  const Pipeline::Result& process(Products products = Product::kPolygons)
  {
    stamp_ += 0.033;
    return pipeline_.process(
        {PointView::depth(depth_.data(), scene_.width * sizeof(float), rays_), stamp_, {}}, products);
  }

  test::BoxScene scene_;
  std::vector<float> depth_;
  PinholeRays rays_;
  Pipeline pipeline_{Pipeline::Parameters{}};
  double stamp_ = 10.0;
};

TEST_F(PipelineTest, PutsAPolygonAroundABox)
{
  const Pipeline::Result& result = process();
  ASSERT_EQ(result.floor.status, FloorStatus::kFound);
  EXPECT_NEAR(result.floor.floor.plane.distance, 0.8, 0.002);
  ASSERT_EQ(result.polygons.rings.size(), 1U);
  EXPECT_FALSE(result.polygons.rings[0].hole);
  Eigen::AlignedBox2d bounds;
  for (const auto& vertex : result.polygons.vertices) bounds.extend(vertex);
  // What is seen of the box, grown by the radius: at least that, and not much more.
  const double radius = 0.30;
  const double slack = 1.5 * 0.05 + 0.05;
  EXPECT_LE(bounds.min().x(), 1.5 - radius + 0.01);
  EXPECT_GE(bounds.min().x(), 1.5 - radius - slack - 0.01);
  EXPECT_LE(bounds.min().y(), 0.1 - radius + 0.01);
  EXPECT_GE(bounds.min().y(), 0.1 - radius - slack - 0.01);
  EXPECT_GE(bounds.max().y(), 0.5 + radius - 0.01);
  EXPECT_LE(bounds.max().y(), 0.5 + radius + slack + 0.01);
}

TEST_F(PipelineTest, MarksTheCellsThatTheBoxStandsIn)
{
  const occupancy::BinaryGrid& grid = process(Product::kOccupancy).occupancy;
  // Its front is at x = 1.5, where a cell begins, from y = 0.1 to 0.5: rows 52 to 59.
  for (int j = 52; j < 60; ++j) {
    EXPECT_FALSE(grid.occupied(28, j)) << "row " << j;
    EXPECT_TRUE(grid.occupied(29, j) || grid.occupied(30, j)) << "row " << j;
  }
  for (int j = 0; j < 50; ++j) {
    for (int i = 0; i < 100; ++i) EXPECT_FALSE(grid.occupied(i, j)) << "cell " << i << ", " << j;
  }
}

TEST_F(PipelineTest, AnExactlyLevelCameraLosesNothing)
{
  // With the paper's axis-angle form the rotation would be NaN here and every point fall into cell (0, 0).
  scene_.floor = {-Eigen::Vector3d::UnitY(), 0.8};
  look();
  const Pipeline::Result& result = process();
  ASSERT_EQ(result.floor.status, FloorStatus::kFound);
  EXPECT_TRUE(result.to_floor_frame.matrix().allFinite());
  EXPECT_FALSE(result.occupancy.occupied(0, 0));
  EXPECT_EQ(result.polygons.rings.size(), 1U);
}

TEST_F(PipelineTest, WithoutAFloorThereAreNoPolygons)
{
  depth_.assign(depth_.size(), std::numeric_limits<float>::quiet_NaN());
  const Pipeline::Result& result = process();
  EXPECT_EQ(result.floor.status, FloorStatus::kNotFound);
  EXPECT_TRUE(result.polygons.rings.empty());
  EXPECT_EQ(result.occupancy.count(), 0U);
  EXPECT_EQ(result.occupancy.geometry().cells_x, 100);
}

TEST_F(PipelineTest, AHeldFloorStillShowsObstacles)
{
  process();
  // Only what lies above the floor is still seen.
  const Eigen::Isometry3d to_floor = scene_.toFloorFrame();
  const PointView view = PointView::depth(depth_.data(), scene_.width * sizeof(float), rays_);
  for (std::uint32_t k = 0; k < depth_.size(); ++k) {
    const Eigen::Vector3d p = to_floor * view.point(k % scene_.width, k / scene_.width).cast<double>();
    if (!(p.z() > 0.02)) depth_[k] = std::numeric_limits<float>::quiet_NaN();
  }
  const Pipeline::Result& result = process();
  EXPECT_EQ(result.floor.status, FloorStatus::kHeld);
  EXPECT_EQ(result.polygons.rings.size(), 1U);
}

TEST_F(PipelineTest, GoesOnlyAsFarAsAsked)
{
  process();
  const Pipeline::Result& result = process(Product::kFloor);
  EXPECT_EQ(result.floor.status, FloorStatus::kFound);
  EXPECT_EQ(result.occupancy.count(), 0U);
  EXPECT_TRUE(result.polygons.rings.empty());
  EXPECT_EQ(result.times.projection.count(), 0);
  EXPECT_EQ(process(Product::kOccupancy).inflated.count(), 0U);
  EXPECT_TRUE(process(Product::kInflation).polygons.rings.empty());
}

TEST_F(PipelineTest, GivesTheProductsThatAreAskedFor)
{
  const Pipeline::Result& result = process({Product::kObstaclePoints, Product::kFloorHull});
  EXPECT_EQ(result.labels.size(), result.samples.samples().size());
  EXPECT_GE(result.floor_hull.size(), 3U);
  ASSERT_FALSE(result.obstacle_points.empty());
  for (const Eigen::Vector3f& point : result.obstacle_points) {
    EXPECT_GT(point.z(), 0.029F) << point.transpose();
    EXPECT_LT(point.z(), 0.601F) << point.transpose();
  }
  EXPECT_EQ(result.occupancy.count(), 0U) << "nobody asked for the grid";
  EXPECT_EQ(result.view.forward, Eigen::Vector3d::UnitZ());
}

TEST_F(PipelineTest, APlaneThatNobodyFollowedGetsANewId)
{
  const auto floor_id = [](const Pipeline::Result& result) {
    for (const SegmentedPlane& plane : result.planes.planes) {
      if (plane.kind == PlaneKind::kFloor) return plane.id;
    }
    return 0U;
  };
  const std::uint32_t first = floor_id(process(Product::kPlanes));
  ASSERT_NE(first, 0U) << "the floor is among the planes";
  EXPECT_EQ(floor_id(process(Product::kPlanes)), first);
  pipeline_.skip();
  EXPECT_EQ(floor_id(process(Product::kPlanes)), first) << "a frame that was left out changes nothing";
  // Whoever reads planes again later knows nothing of what happened meanwhile.
  process(Product::kPolygons);
  EXPECT_GT(floor_id(process(Product::kPlanes)), first);
}

TEST_F(PipelineTest, TakesTheTimeOfTheStagesThatRan)
{
  const auto ran = [](const StageTimes& times) {
    std::string names;
    StageTimes::describe(times, [&names](const char* name, auto time) {
      if (time.count() > 0) names += std::string(name) + ' ';
    });
    return names;
  };
  EXPECT_EQ(ran(process(Product::kFloorHull).times), "samples floor floor hull ");
  EXPECT_EQ(ran(process().times), "samples floor projection inflation polygons ");
}

TEST_F(PipelineTest, KnowsNothingAfterAReset)
{
  process({Product::kPolygons, Product::kFloorHull});
  pipeline_.reset();
  const Pipeline::Result& result = pipeline_.result();
  EXPECT_TRUE(result.products.empty());
  EXPECT_EQ(result.floor.status, FloorStatus::kNotFound);
  EXPECT_TRUE(result.floor_hull.empty());
  EXPECT_TRUE(result.polygons.rings.empty());
  EXPECT_EQ(result.occupancy.geometry().cells_x, 100) << "where nothing is known";
}

TEST_F(PipelineTest, NewParametersHoldFromTheNextFrameOn)
{
  process();
  Pipeline::Parameters parameters;
  parameters.inflation.robot_radius = 0.0;
  parameters.grid.grid_resolution = 0.1;
  pipeline_.configure(parameters);
  const Pipeline::Result& result = process();
  EXPECT_EQ(result.floor.status, FloorStatus::kFound);
  EXPECT_EQ(result.occupancy.geometry().cells_x, 50);
  EXPECT_EQ(result.inflated.cells(), result.occupancy.cells());
}

TEST_F(PipelineTest, ABodyFrameNeedsOnlyItsUpVector)
{
  // The same points with x forward and z up.
  struct Xyz
  {
    float x, y, z;
  };
  std::vector<Xyz> points;
  const PointView view = PointView::depth(depth_.data(), scene_.width * sizeof(float), rays_);
  for (std::uint32_t k = 0; k < depth_.size(); ++k) {
    const Eigen::Vector3f p = view.point(k % scene_.width, k / scene_.width);
    points.push_back({p.z(), -p.x(), -p.y()});
  }
  Pipeline::Parameters parameters;
  parameters.tracker.initial_up = Eigen::Vector3d::UnitZ();
  Pipeline pipeline(parameters);
  const auto& result =
      pipeline.process({PointView::points(points.data(), scene_.width, scene_.height), 1.0, {}});
  ASSERT_EQ(result.floor.status, FloorStatus::kFound);
  EXPECT_EQ(result.occupancy.cells(), process().occupancy.cells());
}

}  // namespace
}  // namespace polygonal_perception::perception

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstring>
#include <vector>

#include "polygonal_perception/perception/input/point_view.hpp"

#ifdef POLYGONAL_PERCEPTION_HAS_PCL
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#endif

namespace polygonal_perception::perception {
namespace {

TEST(PointView, FindsCoordinatesAtAnyOffsetAndStepAndAlignment)
{
  // Two rows of three points, 19 bytes apart, rows padded to 64 bytes; z, x, y from byte 5 on: nothing is
  // aligned.
  PointView::CloudStrides strides;
  strides.point_step = 19;
  strides.row_step = 64;
  strides.z_offset = 5;
  strides.x_offset = 9;
  strides.y_offset = 13;
  std::vector<std::uint8_t> memory(128, 0xFF);
  for (std::uint32_t v = 0; v < 2; ++v) {
    for (std::uint32_t u = 0; u < 3; ++u) {
      const float xyz[] = {10.0F * v + u, 20.0F * v + u, 30.0F * v + u};
      std::uint8_t* const point = memory.data() + 64 * v + 19 * u;
      std::memcpy(point + 9, &xyz[0], 4);
      std::memcpy(point + 13, &xyz[1], 4);
      std::memcpy(point + 5, &xyz[2], 4);
    }
  }
  const PointView view = PointView::cloud(memory.data(), 3, 2, strides);
  EXPECT_EQ(view.size(), 6U);
  EXPECT_EQ(view.point(1, 0), Eigen::Vector3f(1, 1, 1));
  EXPECT_EQ(view.point(2, 1), Eigen::Vector3f(12, 22, 32));
}

/// Whether none of the points is a return.
void expectNoReturns(const PointView& view)
{
  for (std::uint32_t u = 0; u < view.width(); ++u)
    EXPECT_TRUE(view.point(u, 0).hasNaN()) << "pixel " << u << " is at " << view.point(u, 0).transpose();
}

struct Xyz
{
  float x, y, z;
};

TEST(PointView, WhatDriversWriteWhereACloudHasNoReturnIsNone)
{
  const float nan = std::nanf("");
  const Xyz points[] = {{0, 0, 0},         {-0.0F, 0, 0}, {nan, nan, nan},
                        {0, 0, nan},       {nan, 0, 0},   {INFINITY, INFINITY, INFINITY},
                        {0, 0, -INFINITY}, {3e38F, 0, 0}};
  expectNoReturns(PointView::points(points, 8, 1));
}

TEST(PointView, PointsOutsideTheLimitsAreNone)
{
  const Xyz points[] = {{0, 0, 0.49F}, {0.3F, 0.3F, 0.2F}, {0, 0, 4.01F}, {3, 0, 3}, {0, -4.1F, 0}};
  const PointView all = PointView::points(points, 5, 1);
  expectNoReturns(all.within({0.5, 4.0}));
  const Xyz inside[] = {{0, 0, 0.51F}, {0.4F, 0.4F, 0.2F}, {0, 0, 3.99F}, {2, 0, 3}, {0, 0, -2}};
  const PointView kept = PointView::points(inside, 5, 1).within({0.5, 4.0});
  for (std::uint32_t u = 0; u < 5; ++u)
    EXPECT_EQ(kept.point(u, 0), Eigen::Vector3f(inside[u].x, inside[u].y, inside[u].z));
  EXPECT_EQ(all.within({0.5, 0.0}).point(2, 0).z(), 4.01F) << "0 is no limit";
  EXPECT_EQ(all.point(0, 0).z(), 0.49F) << "the view itself stays what it was";
}

TEST(PointView, PointsInTheBoxesAreNone)
{
  // A box of a frame that is turned by 90 degrees about z and lies 1 m ahead.
  Eigen::Isometry3d input_to_box = Eigen::Isometry3d::Identity();
  input_to_box.linear() = Eigen::AngleAxisd(-M_PI_2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  input_to_box.translation() = input_to_box.linear() * Eigen::Vector3d(-1.0, 0.0, 0.0);
  IgnoredBoxes boxes;
  boxes.add(input_to_box, {Eigen::Vector3d(-0.1, -0.5, 0.0), Eigen::Vector3d(0.1, 0.5, 0.2)});
  boxes.add(Eigen::Isometry3d::Identity(), {Eigen::Vector3d(4.0, 4.0, 4.0), Eigen::Vector3d(5.0, 5.0, 5.0)});
  const Xyz in[] = {{1.4F, 0.0F, 0.1F}, {0.6F, 0.09F, 0.1F}, {4.5F, 4.5F, 4.5F}};
  expectNoReturns(PointView::points(in, 3, 1).without(boxes));
  const Xyz out[] = {{1.6F, 0.0F, 0.1F}, {1.0F, 0.2F, 0.1F}, {1.0F, 0.0F, 0.3F}, {5.5F, 4.5F, 4.5F}};
  const PointView kept = PointView::points(out, 4, 1).without(boxes);
  for (std::uint32_t u = 0; u < 4; ++u)
    EXPECT_EQ(kept.point(u, 0), Eigen::Vector3f(out[u].x, out[u].y, out[u].z)) << u;
  EXPECT_EQ(PointView::points(in, 3, 1).without(IgnoredBoxes{}).point(0, 0).x(), 1.4F) << "no boxes";
}

class DepthView : public ::testing::Test
{
protected:
  // Pixel (1, 0) is on the optical axis; the slopes of the others are multiples of 1/100.
  PinholeRays rays_ = PinholeRays::make(3, 2, 100.0, 200.0, 1.0, 0.0);
};

TEST_F(DepthView, ReadsMillimetres)
{
  const std::uint16_t depth[] = {1000, 2000, 0, 500, 4000, 65535};
  const PointView view = PointView::depth(depth, 6, rays_);
  EXPECT_TRUE(view.point(0, 0).isApprox(Eigen::Vector3f(-0.01F, 0.0F, 1.0F), 1e-6F));
  EXPECT_TRUE(view.point(1, 1).isApprox(Eigen::Vector3f(0.0F, 0.02F, 4.0F), 1e-6F))
      << view.point(1, 1).transpose();
  EXPECT_TRUE(view.point(2, 0).array().isNaN().all());
  EXPECT_TRUE(view.point(2, 1).array().isNaN().all()) << "65535: none, as some drivers write it";
}

TEST_F(DepthView, ReadsOtherUnits)
{
  const std::uint16_t depth[] = {4000, 8000, 0, 2000, 65534, 65535};
  const PointView view = PointView::depth(depth, 6, rays_, 0.00025);
  EXPECT_TRUE(view.point(0, 0).isApprox(Eigen::Vector3f(-0.01F, 0.0F, 1.0F), 1e-6F));
  EXPECT_NEAR(view.point(1, 1).z(), 16.3835, 1e-4);
  EXPECT_TRUE(view.point(2, 1).hasNaN());
}

TEST_F(DepthView, LimitsAreOfTheRangeNotOfTheDepth)
{
  const PinholeRays wide = PinholeRays::make(3, 1, 1.0, 1.0, 1.0, 0.0);  // 45 degrees to both sides
  const float depth[] = {1.0F, 1.0F, 0.8F};
  const PointView view = PointView::depth(depth, 12, wide).within({0.5, 1.2});
  EXPECT_TRUE(view.point(0, 0).hasNaN()) << "1.41 m away";
  EXPECT_EQ(view.point(1, 0).z(), 1.0F);
  EXPECT_EQ(view.point(2, 0).z(), 0.8F) << "1.13 m away";
}

TEST_F(DepthView, ReadsMetresWithPaddedRows)
{
  const float nan = std::nanf("");
  const float depth[] = {1.0F, nan, 0.0F, 99.0F, -1.0F, 2.0F, INFINITY, 99.0F};
  const PointView view = PointView::depth(depth, 16, rays_);
  EXPECT_TRUE(view.point(0, 0).isApprox(Eigen::Vector3f(-0.01F, 0.0F, 1.0F), 1e-6F));
  EXPECT_TRUE(view.point(1, 1).isApprox(Eigen::Vector3f(0.0F, 0.01F, 2.0F), 1e-6F))
      << view.point(1, 1).transpose();
  for (const auto& [u, v] : {std::pair(1U, 0U), std::pair(2U, 0U), std::pair(0U, 1U)}) {
    EXPECT_TRUE(view.point(u, v).array().isNaN().all()) << "at " << u << ", " << v;
  }
}

#ifdef POLYGONAL_PERCEPTION_HAS_PCL

template <class Point>
void expectViewOf()
{
  pcl::PointCloud<Point> cloud(4, 3);
  for (std::uint32_t k = 0; k < 12; ++k) {
    cloud.points[k].x = static_cast<float>(k);
    cloud.points[k].y = 100.0F + static_cast<float>(k);
    cloud.points[k].z = 200.0F + static_cast<float>(k);
  }
  const PointView view = PointView::points(cloud.points.data(), cloud.width, cloud.height);
  EXPECT_EQ(view.point(0, 0), Eigen::Vector3f(0, 100, 200));
  EXPECT_EQ(view.point(3, 2), Eigen::Vector3f(11, 111, 211));
  EXPECT_EQ(static_cast<const void*>(view.row(0)), static_cast<const void*>(cloud.points.data())) << "copied";
}

TEST(PointView, OfAPclCloudIsTheCloudItself)
{
  expectViewOf<pcl::PointXYZ>();
  expectViewOf<pcl::PointXYZRGB>();
  expectViewOf<pcl::PointXYZRGBNormal>();
}

#endif

}  // namespace
}  // namespace polygonal_perception::perception

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <vector>

#include "polygonal_perception/perception/floor/floor_hull.hpp"

namespace polygonal_perception::perception {
namespace {

constexpr std::uint32_t kWidth = 40;
constexpr std::uint32_t kHeight = 30;

/// A camera 1 m above a floor at y = 1 (optical frame): pixel (u, v) sees the floor at x = (u - 20) / 10, z =
/// v / 10 + 1.
std::vector<Eigen::Vector3f> floorPoints()
{
  std::vector<Eigen::Vector3f> points;
  for (std::uint32_t v = 0; v < kHeight; ++v) {
    for (std::uint32_t u = 0; u < kWidth; ++u) {
      points.emplace_back((static_cast<float>(u) - 20.0F) / 10.0F, 1.0F,
                          static_cast<float>(v) / 10.0F + 1.0F);
    }
  }
  return points;
}

PointView viewOf(const std::vector<Eigen::Vector3f>& points)
{
  PointView::CloudStrides strides;
  strides.point_step = sizeof(Eigen::Vector3f);
  strides.row_step = kWidth * strides.point_step;
  return PointView::cloud(points.data(), kWidth, kHeight, strides);
}

const geometry::Plane kFloor{-Eigen::Vector3d::UnitY(), 1.0};

TEST(FloorHull, IsTheRectangleOfSamplesCounterClockwiseFromAbove)
{
  const std::vector<Eigen::Vector3f> points = floorPoints();
  SampleGrid samples(SampleGrid::Parameters{});
  samples.update(viewOf(points));
  const std::vector<SampleLabel> labels(samples.samples().size(), SampleLabel::kFloor);

  const std::vector<Eigen::Vector3f> hull = floorHull(samples, labels, kFloor);
  ASSERT_EQ(hull.size(), 4U);
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    EXPECT_NEAR(std::abs(hull[i].x() + 0.05F), 1.95, 1e-5) << hull[i].transpose();
    EXPECT_NEAR(hull[i].y(), 1.0, 1e-6);
    EXPECT_NEAR(std::abs(hull[i].z() - 2.45F), 1.45, 1e-5) << hull[i].transpose();
    area += hull[i].cast<double>().cross(hull[(i + 1) % hull.size()].cast<double>()) / 2.0;
  }
  EXPECT_NEAR(area.dot(kFloor.normal), 3.9 * 2.9, 1e-5) << "counter-clockwise means a positive area";
}

TEST(FloorHull, LiesOnThePlaneWhereSamplesDoNot)
{
  const std::vector<Eigen::Vector3f> points = floorPoints();
  SampleGrid samples(SampleGrid::Parameters{});
  samples.update(viewOf(points));
  const std::vector<SampleLabel> labels(samples.samples().size(), SampleLabel::kFloor);
  const geometry::Plane tilted{Eigen::Vector3d(0.05, -1.0, 0.1).normalized(), 1.2};
  for (const Eigen::Vector3f& corner : floorHull(samples, labels, tilted)) {
    EXPECT_NEAR(tilted.height(corner.cast<double>()), 0.0, 1e-6);
  }
}

TEST(FloorHull, TakesNoSampleThatIsNotFloor)
{
  const std::vector<Eigen::Vector3f> points = floorPoints();
  SampleGrid samples(SampleGrid::Parameters{});
  samples.update(viewOf(points));
  std::vector<SampleLabel> labels(samples.samples().size(), SampleLabel::kSegment);
  EXPECT_TRUE(floorHull(samples, labels, kFloor).empty());
  // One row of samples is a line.
  for (int i = 0; i < samples.samplesX(); ++i) labels[static_cast<std::size_t>(i)] = SampleLabel::kFloor;
  EXPECT_TRUE(floorHull(samples, labels, kFloor).empty());
  labels.back() = SampleLabel::kFloor;
  EXPECT_EQ(floorHull(samples, labels, kFloor).size(), 3U);
}

}  // namespace
}  // namespace polygonal_perception::perception

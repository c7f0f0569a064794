#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "polygonal_perception/perception/grid/projection.hpp"
#include "support/every_kernel.hpp"
#include "support/projection_scene.hpp"
#include "support/random_frame.hpp"
#include "support/reference_projection.hpp"

namespace polygonal_perception::perception {
namespace {

/// A camera frame with z up, 1 m above the floor.
const geometry::Plane kFloor{Eigen::Vector3d::UnitZ(), 1.0};
const SensorNoise kTenthOfRange{0.0, 0.1, 0.0};

TEST(HeightNoise, IsThePartOfTheDepthsAlongTheFloorsNormal)
{
  const HeightNoise noise(kTenthOfRange, kFloor, Eigen::Matrix4d::Zero());
  // Straight below, the whole error of 0.1 m goes into the height; at 3-4-5 ahead, three fifths of 0.5 m.
  EXPECT_NEAR(noise.sigma({0.0F, 0.0F, -1.0F}), 0.1F, 1e-6F);
  EXPECT_NEAR(noise.sigma({4.0F, 0.0F, -3.0F}), 0.3F, 1e-6F);
  EXPECT_NEAR(noise.sigma({2.0F, 0.0F, 0.0F}), 0.0F, 1e-6F)
      << "a point at the camera's height moves along the floor";
}

TEST(HeightNoise, HasTheFloorsOwnUncertainty)
{
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
  covariance(0, 0) = 0.01 * 0.01;  // the normal tilts along x
  covariance(3, 3) = 0.02 * 0.02;
  const HeightNoise noise({0.0, 0.0, 0.0}, kFloor, covariance);
  EXPECT_NEAR(noise.sigma({0.0F, 5.0F, -1.0F}), 0.02F, 1e-4F);
  EXPECT_NEAR(noise.sigma({5.0F, 0.0F, -1.0F}), std::hypot(0.05F, 0.02F), 1e-4F);
}

class HeightSigmas : public test::EveryKernel
{
};

TEST_P(HeightSigmas, LeaveOutWhatIsNotAboveTheFloorBeyondDoubt)
{
  std::mt19937 random(9);
  std::size_t left_out = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const test::RandomFrame frame(random);
    const PointView view = frame.view();
    const Eigen::Isometry3d to_floor = test::tiltedCamera();
    const geometry::Plane floor{to_floor.linear().row(2).transpose(), to_floor.translation().z()};
    const HeightNoise noise({0.01, 0.0, 0.02}, floor, Eigen::Matrix4d::Identity() * 1e-4);
    Projection::Parameters parameters;
    parameters.height_sigmas = 3.0;
    occupancy::BinaryGrid grid{occupancy::GridGeometry(occupancy::GridParameters{})};
    Projection projection(parameters, kernel());
    projection.project(view, to_floor, grid, {&noise, nullptr});

    const test::ReferenceProjection reference(parameters, to_floor, grid.geometry());
    occupancy::BinaryGrid expected{grid.geometry()};
    for (std::uint32_t v = 0; v < view.height(); ++v) {
      for (std::uint32_t u = 0; u < view.width(); ++u) {
        const auto cell = reference.cell(view, u, v);
        if (!cell) continue;
        const Eigen::Vector3d point = view.point(u, v).cast<double>();
        const double height = floor.normal.dot(point) + floor.distance;
        const double of_point =
            (height - floor.distance) / point.norm() * (0.01 + 0.02 * point.squaredNorm());
        const double sigma = std::sqrt(of_point * of_point + 1e-4 * (point.squaredNorm() + 1.0));
        // Single precision decides at the border itself.
        if (std::abs(height - 3.0 * sigma) < 1e-5) expected.row(0)[*cell] = grid.row(0)[*cell];
        if (height > 3.0 * sigma) expected.row(0)[*cell] = 1;
        left_out += height > 3.0 * sigma ? 0 : 1;
      }
    }
    ASSERT_EQ(grid.cells(), expected.cells()) << "trial " << trial;
    projection.project(view, to_floor, grid);
    ASSERT_EQ(grid.cells(), reference.project(view).cells()) << "exact heights, trial " << trial;
  }
  EXPECT_GT(left_out, 1000U) << "too few points to tell anything";
}

INSTANTIATE_TEST_SUITE_P(Kernel, HeightSigmas, testing::ValuesIn(test::kKernelNames), test::nameOfKernel);

}  // namespace
}  // namespace polygonal_perception::perception

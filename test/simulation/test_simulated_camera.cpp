#include <gtest/gtest.h>

#include <cmath>

#include "polygonal_perception/cameras/simulation/simulated_camera.hpp"

namespace polygonal_perception::simulation {
namespace {

SimulatedCamera::Options small(const std::string& scene, const std::string& trajectory, std::uint64_t seed)
{
  SimulatedCamera::Options options;
  options.scene = scene;
  options.trajectory = trajectory;
  options.seed = seed;
  options.camera = PinholeCamera::ofSize(160, 120);
  return options;
}

Eigen::Vector3d point(const PinholeCamera& camera, std::size_t pixel, float z)
{
  const auto u = static_cast<double>(pixel % camera.width);
  const std::size_t row = pixel / camera.width;
  const auto v = static_cast<double>(row);
  return z * Eigen::Vector3d((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0);
}

TEST(SimulatedCamera, FloorPlaneIsTheOneThatFloorPixelsLieOn)
{
  for (const std::string& scene : sceneNames()) {
    SimulatedCamera::Options options = small(scene, "smooth_high", 2);
    options.noise = DepthNoise::Parameters::none();
    SimulatedCamera camera(options);
    SimulatedFrame frame;
    std::size_t floor_pixels = 0;
    for (std::uint32_t index = 0; index < 300; index += 30) {
      camera.render(index, frame);
      EXPECT_NEAR(frame.floor.normal.norm(), 1.0, 1e-12);
      EXPECT_LT(frame.floor.normal.y(), 0.0) << "up in an optical frame";
      for (std::size_t i = 0; i < frame.depth.size(); ++i) {
        const double height = frame.floor.height(point(options.camera, i, frame.depth[i]));
        if (frame.truth.surface[i] == Surface::kFloor) {
          ++floor_pixels;
          // Mats are up to 5 mm high.
          ASSERT_GT(height, -1e-4) << scene << " frame " << index;
          ASSERT_LT(height, scene.find("office") == std::string::npos ? 1e-4 : 0.0051)
              << scene << " frame " << index;
        } else if (frame.truth.surface[i] == Surface::kLowerFloor) {
          ASSERT_LT(height, 1e-4) << scene;
        }
      }
    }
    EXPECT_GT(floor_pixels, 1000U) << scene;
  }
}

TEST(SimulatedCamera, ObstaclePointsLieInTheOutlines)
{
  for (const std::string scene : {"office", "person", "doorway"}) {
    SimulatedCamera::Options options = small(scene, "robotino", 3);
    options.noise = DepthNoise::Parameters::none();
    SimulatedCamera camera(options);
    SimulatedFrame frame;
    for (std::uint32_t index : {0U, 200U}) {
      camera.render(index, frame);
      const std::vector<Outline> obstacles = camera.scene().obstacles(frame.time, 0.03, 0.6);
      for (std::size_t i = 0; i < frame.depth.size(); i += 7) {
        const Eigen::Vector3d p = frame.camera_to_world * point(options.camera, i, frame.depth[i]);
        if (!(p.z() > 0.031 && p.z() < 0.599)) continue;
        double nearest = 1e9;
        for (const Outline& outline : obstacles)
          nearest = std::min(nearest, distanceTo(outline, p.head<2>()));
        ASSERT_LT(nearest, 1e-4) << scene << " frame " << index << " at " << p.transpose();
      }
    }
  }
}

TEST(SimulatedCamera, SeveralAreSpreadEvenlyAroundTheRobot)
{
  SimulatedCamera::Options options = small("office", "nao", 5);
  const SimulatedCamera only(options);
  options.count = 3;
  for (std::uint32_t number = 0; number < 3; ++number) {
    options.number = number;
    const SimulatedCamera camera(options);
    for (const std::uint32_t index : {0U, 45U}) {
      const Eigen::Isometry3d robot = only.base(index);
      EXPECT_TRUE(camera.base(index).isApprox(robot)) << number;
      const Eigen::Isometry3d turned = robot.inverse() * camera.pose(index);
      const Eigen::Isometry3d first = robot.inverse() * only.pose(index);
      const Eigen::AngleAxisd turn(number * 2.0 * EIGEN_PI / 3.0, Eigen::Vector3d::UnitZ());
      EXPECT_TRUE(turned.isApprox(turn * first, 1e-9)) << number << '\n' << turned.matrix();
    }
  }
  options.number = 3;
  EXPECT_THROW(SimulatedCamera{options}, std::invalid_argument);
}

TEST(SimulatedCamera, FloorIsSeenInEverySceneOverATrajectory)
{
  for (const std::string& scene : sceneNames()) {
    for (const std::string& trajectory : trajectoryNames()) {
      SimulatedCamera camera(small(scene, trajectory, 1));
      SimulatedFrame frame;
      double most = 0.0;
      for (std::uint32_t index = 0; index < 1200; index += 40) {
        camera.render(index, frame);
        most = std::max(most, frame.floor_fraction);
      }
      EXPECT_GT(most, 0.02) << scene << ' ' << trajectory;
    }
  }
}

TEST(SimulatedCamera, FramesDoNotDependOnTheirOrder)
{
  SimulatedCamera forwards(small("person", "nao", 7));
  SimulatedCamera backwards(small("person", "nao", 7));
  SimulatedFrame frame;
  std::vector<std::vector<std::uint16_t>> seen;
  std::vector<std::uint16_t> millimetres(forwards.options().camera.size());
  for (std::uint32_t index = 0; index < 4; ++index) {
    forwards.render(index, frame);
    toMillimetres(frame.depth, millimetres.data());
    seen.push_back(millimetres);
  }
  for (std::uint32_t index = 4; index-- > 0;) {
    backwards.render(index, frame);
    toMillimetres(frame.depth, millimetres.data());
    EXPECT_EQ(millimetres, seen[index]) << index;
  }
  EXPECT_NE(seen[0], seen[1]);
}

TEST(SimulatedCamera, MillimetresAreRoundedAndZeroWhereThereIsNone)
{
  std::uint16_t out[5];
  toMillimetres({1.2344F, 1.2346F, NAN, 70.0F, 0.0F}, out);
  EXPECT_EQ(out[0], 1234);
  EXPECT_EQ(out[1], 1235);
  EXPECT_EQ(out[2], 0);
  EXPECT_EQ(out[3], 0);
  EXPECT_EQ(out[4], 0);
}

}  // namespace
}  // namespace polygonal_perception::simulation

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "polygonal_perception/cameras/simulation/trajectory.hpp"

namespace polygonal_perception::simulation {
namespace {

constexpr double kDegree = M_PI / 180.0;

double pitchOf(const Eigen::Isometry3d& pose)
{
  return -std::asin(pose.linear()(2, 2));
}
double rollOf(const Eigen::Isometry3d& pose)
{
  return std::asin(pose.linear()(2, 0) / std::cos(pitchOf(pose)));
}

TEST(Trajectory, OpticalPoseOfALevelCameraLooksAlongItsHeading)
{
  const Eigen::Isometry3d pose = opticalPose({1, 2, 0.8}, M_PI / 2, 0.0, 0.0);
  EXPECT_TRUE((pose * Eigen::Vector3d(0, 0, 3)).isApprox(Eigen::Vector3d(1, 5, 0.8), 1e-12)) << "forward";
  EXPECT_TRUE((pose * Eigen::Vector3d(1, 0, 0)).isApprox(Eigen::Vector3d(2, 2, 0.8), 1e-12)) << "right";
  EXPECT_TRUE((pose * Eigen::Vector3d(0, 0.8, 0)).isApprox(Eigen::Vector3d(1, 2, 0.0), 1e-12)) << "down";
}

TEST(Trajectory, PitchIsDownwards)
{
  const Eigen::Isometry3d pose = opticalPose({0, 0, 1}, 0.0, 45 * kDegree, 0.0);
  EXPECT_NEAR((pose * Eigen::Vector3d(0, 0, std::sqrt(2.0))).z(), 0.0, 1e-12);
  EXPECT_NEAR(pitchOf(opticalPose({0, 0, 1}, 2.0, 0.3, 0.1)), 0.3, 1e-12);
  EXPECT_NEAR(std::abs(rollOf(opticalPose({0, 0, 1}, 2.0, 0.3, 0.1))), 0.1, 1e-12);
}

TEST(Trajectory, EverySceneHasRoomForEachAndNothingIsInTheCamera)
{
  for (const std::string& scene_name : sceneNames()) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      const Scene scene = makeScene(scene_name, seed);
      for (const std::string& name : trajectoryNames()) {
        SCOPED_TRACE(scene_name);
        SCOPED_TRACE(name);
        const auto trajectory = makeTrajectory(name, scene, seed);
        for (int look = 0; look < 8; ++look) {
          const double time = 7.7 * look;
          const Eigen::Vector3d camera = trajectory->pose(time).translation();
          const Eigen::Vector2d place = camera.head<2>();
          bool on_floor = false;
          for (const Outline& floor : scene.floor) on_floor |= distanceTo(floor, place) == 0.0;
          EXPECT_TRUE(on_floor) << "seed " << seed << " at " << camera.transpose();
          for (const Outline& outline : scene.obstacles(time, camera.z() - 0.05, camera.z() + 0.05)) {
            EXPECT_GT(distanceTo(outline, place), 0.1) << "seed " << seed << " at " << camera.transpose();
          }
        }
      }
    }
  }
}

TEST(Trajectory, RangesAreKept)
{
  const Scene scene = makeScene("office", 3);
  struct Range
  {
    std::string kind;
    double low;
    double high;
  };
  for (const Range& range : {Range{"lowest", 0.2, 0.5}, Range{"low", 0.4, 0.7}, Range{"high", 0.7, 1.5}}) {
    for (const std::string motion : {"smooth_", "independent_"}) {
      const std::string name = motion + range.kind;
      const auto trajectory = makeTrajectory(name, scene, 3);
      double steepest = 0.0;
      double flattest = 1.0;
      for (int frame = 0; frame < 3000; ++frame) {
        const Eigen::Isometry3d pose = trajectory->pose(frame / 30.0);
        EXPECT_GE(pose.translation().z(), range.low) << name;
        EXPECT_LE(pose.translation().z(), range.high) << name;
        EXPECT_GE(pitchOf(pose), -1e-9);
        EXPECT_LE(pitchOf(pose), 45 * kDegree + 1e-9);
        EXPECT_LE(std::abs(rollOf(pose)), 15 * kDegree + 1e-9);
        steepest = std::max(steepest, pitchOf(pose));
        flattest = std::min(flattest, pitchOf(pose));
      }
      EXPECT_GT(steepest, 35 * kDegree) << name;
      EXPECT_LT(flattest, 10 * kDegree) << name;
    }
  }
}

TEST(Trajectory, RobotsMoveAsRobotsDo)
{
  const Scene scene = makeScene("corridor", 4);
  for (const std::string name : {"robotino", "nao", "smooth_low", "smooth_high"}) {
    const auto trajectory = makeTrajectory(name, scene, 4);
    double way = 0.0;
    Eigen::Isometry3d last = trajectory->pose(0.0);
    for (int frame = 1; frame < 900; ++frame) {
      const Eigen::Isometry3d pose = trajectory->pose(frame / 30.0);
      const double step = (pose.translation() - last.translation()).norm();
      EXPECT_LT(step, 0.03) << name << " frame " << frame;
      EXPECT_LT(Eigen::AngleAxisd(last.linear().transpose() * pose.linear()).angle(), 6 * kDegree) << name;
      way += step;
      last = pose;
    }
    EXPECT_GT(way, 1.0) << name;
  }
}

TEST(Trajectory, NaoSwaysAndNods)
{
  const Scene scene = makeScene("corridor", 4);
  const auto trajectory = makeTrajectory("nao", scene, 4);
  double lowest_roll = 1.0;
  double highest_roll = -1.0;
  for (int frame = 0; frame < 150; ++frame) {
    const double roll = rollOf(trajectory->pose(frame / 30.0));
    lowest_roll = std::min(lowest_roll, roll);
    highest_roll = std::max(highest_roll, roll);
  }
  EXPECT_LT(lowest_roll, -1.5 * kDegree);
  EXPECT_GT(highest_roll, 1.5 * kDegree);
}

TEST(Trajectory, InACourseTheRobotDrivesItsWayAsTiltedAsTheGround)
{
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Scene scene = makeScene("ramps", seed);
    const auto trajectory = makeTrajectory("robotino", scene, seed);
    double highest = 0.0;
    double steepest = 0.0;
    double farthest = -1e9;
    for (double time = 0.0; time < 100.0; time += 0.1) {
      const Eigen::Isometry3d base = trajectory->base(time);
      const Eigen::Vector3d place = base.translation();
      EXPECT_TRUE(base.linear().isUnitary(1e-9) && base.linear().determinant() > 0.0);
      // On a crest the wheels carry the robot's middle over it or let it sink by a few millimetres.
      EXPECT_NEAR(place.z(), scene.groundHeight(place.head<2>()), 0.01)
          << "seed " << seed << " at " << place.transpose();
      const Eigen::Vector3d camera = base.inverse() * trajectory->pose(time).translation();
      EXPECT_LT(camera.head<2>().norm(), 1e-9) << "above the robot's middle";
      for (const Outline& outline : scene.obstacles(time, place.z() + 0.1, place.z() + 0.5))
        EXPECT_GT(distanceTo(outline, place.head<2>()), 0.3)
            << "seed " << seed << " at " << place.transpose();
      highest = std::max(highest, place.z());
      steepest = std::max(steepest, std::acos(base.linear()(2, 2)));
      farthest = std::max(farthest, place.x());
    }
    EXPECT_GT(highest, 0.12) << "seed " << seed;
    EXPECT_GT(steepest, 3.9 * kDegree) << "seed " << seed;
    EXPECT_LT(steepest, 7.2 * kDegree) << "seed " << seed;
    EXPECT_GT(farthest, 8.0) << "seed " << seed;
  }
}

TEST(Trajectory, UnknownNameIsRefused)
{
  EXPECT_THROW(makeTrajectory("flying", makeScene("office", 1), 1), std::invalid_argument);
}

}  // namespace
}  // namespace polygonal_perception::simulation

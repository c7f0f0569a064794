// The runs of the paper's section V, with the parameters that the package ships for each robot.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <opencv2/imgproc.hpp>

#include "reference/error_statistics.hpp"
#include "ros/perception/floor_transforms.hpp"
#include "shipped_config.hpp"
#include "tracked_leg.hpp"

namespace polygonal_perception::test {
namespace {

using simulation::SimulatedCamera;
using simulation::SimulatedFrame;
using simulation::Surface;

constexpr int kFrames = 450;
constexpr double kRate = 15.0;       // [Hz]
constexpr double kClearance = 0.25;  // [m] beside two radii: cells and the simplification's tolerance

class RobotRun : public testing::Test
{
protected:
  void run(const std::string& scene, const std::string& robot, std::uint64_t seed)
  {
    simulation::SimulatedCamera::Options options;
    options.scene = scene;
    options.trajectory = robot;
    options.seed = seed;
    options.rate = kRate;
    options.camera = simulation::PinholeCamera::ofSize(320, 240);
    simulation::SimulatedCamera camera(options);
    parameters_ = shippedParameters(CONFIG_FOLDER "/" + robot + ".yaml");
    legs_ = findLegs(camera.scene(), parameters_.projection.min_height, parameters_.projection.max_height,
                     2.0 * parameters_.inflation.robot_radius + kClearance);
    const auto& pinhole = options.camera;
    const perception::PinholeRays rays = perception::PinholeRays::make(
        pinhole.width, pinhole.height, pinhole.fx, pinhole.fy, pinhole.cx, pinhole.cy);
    perception::Pipeline pipeline(parameters_);
    simulation::SimulatedFrame frame;
    for (int k = 0; k < kFrames; ++k) {
      camera.render(static_cast<std::uint32_t>(k), frame);
      SCOPED_TRACE(robot + ", frame " + std::to_string(k));
      const perception::PointView view =
          perception::PointView::depth(frame.depth.data(), pinhole.width * sizeof(float), rays);
      const perception::Pipeline::Result& result = pipeline.process({view, frame.time, {}});
      ASSERT_EQ(result.floor.status, perception::FloorStatus::kFound);
      checkFloor(result.floor.floor.plane, frame);
      // As the node places them with output_frame odom, where odometry is right.
      place_ = ros_perception::poseInOutputFrame(frame.camera_to_world, result.to_floor_frame);
      placePolygons(result.polygons);
      checkObstacles(frame, pinhole, camera.scene());
      trackLegs(frame, pinhole);
    }
  }

  void checkFloor(const geometry::Plane& found, const simulation::SimulatedFrame& frame)
  {
    const double degrees = reference::normalError(found, frame.floor);
    const double millimetres = reference::heightError(found, frame.floor);
    EXPECT_LT(degrees, kNormalBound);
    EXPECT_LT(millimetres, kHeightBound);
    worst_degrees_ = std::max(worst_degrees_, degrees);
    worst_millimetres_ = std::max(worst_millimetres_, millimetres);
  }

  void TearDown() override
  {
    std::printf("%d floors within %.3f deg and %.2f mm; %zu points of obstacles\n", kFrames, worst_degrees_,
                worst_millimetres_, points_);
  }

  void placePolygons(const geometry::PolygonSet& polygons)
  {
    boundaries_.clear();
    for (const geometry::PolygonSet::Ring& ring : polygons.rings) {
      if (ring.hole) continue;
      boundaries_.emplace_back();
      for (std::uint32_t i = 0; i < ring.size; ++i)
        boundaries_.back().push_back(place_ * polygons.vertices[ring.first + i]);
    }
  }

  const Ring* boundaryAround(const Eigen::Vector2d& point) const
  {
    for (const Ring& ring : boundaries_) {
      std::vector<cv::Point2f> corners;
      for (const Eigen::Vector2d& p : ring)
        corners.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()));
      const cv::Point2f q(static_cast<float>(point.x()), static_cast<float>(point.y()));
      if (cv::pointPolygonTest(corners, q, false) >= 0.0) return &ring;
    }
    return nullptr;
  }

  /// Every point of an obstacle that the camera saw lies in a polygon.
  void checkObstacles(const simulation::SimulatedFrame& frame, const simulation::PinholeCamera& camera,
                      const simulation::Scene& scene)
  {
    bool sees_walker = false;
    constexpr std::size_t kStride = 7;
    const Eigen::Isometry2d to_floor = place_.inverse();
    for (std::size_t i = 0; i < frame.depth.size(); i += kStride) {
      const std::size_t row = i / camera.width;
      const double z = frame.truth.depth[i];
      // At an edge the sensor may return what lies behind.
      if (frame.truth.surface[i] != simulation::Surface::kObstacle ||
          !(std::abs(frame.depth[i] - z) < 0.05 * z))
        continue;
      const Eigen::Vector3d point =
          frame.camera_to_world *
          Eigen::Vector3d((static_cast<double>(i % camera.width) - camera.cx) / camera.fx * z,
                          (static_cast<double>(row) - camera.cy) / camera.fy * z, z);
      const Eigen::Vector2d on_floor = to_floor * point.head<2>().eval();
      const bool counts = point.z() > parameters_.projection.min_height + kHeightMargin &&
                          point.z() < parameters_.projection.max_height - kHeightMargin &&
                          on_floor.x() > 0.1 && on_floor.x() < 4.7 && std::abs(on_floor.y()) < 2.3;
      if (!counts) continue;
      ++points_;
      for (const simulation::Walker& walker : scene.walkers)
        sees_walker |= (walker.at(frame.time).position - point.head<2>()).norm() < kWalkerRadius;
      EXPECT_NE(boundaryAround(point.head<2>()), nullptr)
          << "a point at " << point.transpose() << ", pixel " << i << ", measured " << frame.depth[i]
          << " m instead of " << z << " m, is in no polygon";
    }
    frames_with_walker_ += sees_walker ? 1 : 0;
  }

  void trackLegs(const simulation::SimulatedFrame& frame, const simulation::PinholeCamera& camera)
  {
    for (TrackedLeg& leg : legs_) {
      if (!leg.isInView(frame, camera)) continue;
      const Ring* boundary = boundaryAround(leg.centre());
      // Behind something else it does not show, and may lie in that thing's polygon.
      if (boundary != nullptr && areaOf(*boundary) < kLargestLegs * legArea()) leg.add(*boundary);
    }
  }

  static double areaOf(const Ring& ring)
  {
    double twice = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Eigen::Vector2d& a = ring[i];
      const Eigen::Vector2d& b = ring[(i + 1) % ring.size()];
      twice += a.x() * b.y() - a.y() * b.x();
    }
    return 0.5 * twice;
  }
  double legArea() const { return M_PI * std::pow(parameters_.inflation.robot_radius + 0.1, 2); }

  /// Of the leg that was seen most often.
  Spread steadiest() const
  {
    Spread most;
    for (const TrackedLeg& leg : legs_) {
      const Spread spread = leg.spread();
      if (spread.frames > most.frames) most = spread;
    }
    return most;
  }

  static constexpr double kNormalBound = 0.5;    // [deg]
  static constexpr double kHeightBound = 10.0;   // [mm]
  static constexpr double kHeightMargin = 0.05;  // [m] for noise
  static constexpr double kWalkerRadius = 0.35;  // [m]
  static constexpr double kLargestLegs = 1.5;

  perception::Pipeline::Parameters parameters_;
  std::vector<TrackedLeg> legs_;
  Eigen::Isometry2d place_ = Eigen::Isometry2d::Identity();
  std::vector<Ring> boundaries_;
  std::size_t points_ = 0;  // of obstacles
  int frames_with_walker_ = 0;
  double worst_degrees_ = 0.0;
  double worst_millimetres_ = 0.0;
};

void expectSteady(const Spread& spread)
{
  EXPECT_LT(spread.standard_deviation, 0.02);
  EXPECT_LT(spread.greatest, 0.05);
  EXPECT_LT(spread.bias, 0.03);
  std::printf("a table's leg in %zu frames: standard deviation %.1f mm, at most %.1f mm, bias %.1f mm\n",
              spread.frames, 1e3 * spread.standard_deviation, 1e3 * spread.greatest, 1e3 * spread.bias);
}

TEST_F(RobotRun, RobotinoDrivesThroughAnOfficeInWhichSomebodyWalks)
{
  run("busy_office", "robotino", 14);
  EXPECT_GT(points_, 10000U);
  EXPECT_GT(frames_with_walker_, 50);
}

TEST_F(RobotRun, NaoWalksAndATablesLegStaysWhereItIs)
{
  run("office", "nao", 5);
  EXPECT_GT(points_, 10000U);
  const Spread spread = steadiest();
  EXPECT_GT(spread.frames, 300U);
  expectSteady(spread);
}

}  // namespace
}  // namespace polygonal_perception::test

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "extracted_scene.hpp"
#include "polygonal_perception/geometry/angle.hpp"
#include "segmentation_stage.hpp"

namespace polygonal_perception::perception {
namespace {

using test::around;
using test::PlaneScene;
using test::Stage;
using test::wallAt;

constexpr double kDegree = 0.017453292519943295;

const Eigen::Vector3d kUp = -Eigen::Vector3d::UnitY();

/// The listed plane with a normal, or nothing.
const SegmentedPlane* withNormal(const std::vector<SegmentedPlane>& planes, const Eigen::Vector3d& normal)
{
  const auto found = std::find_if(planes.begin(), planes.end(), [&](const SegmentedPlane& plane) {
    return geometry::angleBetween(plane.plane.normal, normal) < 1.0 * kDegree;
  });
  return found == planes.end() ? nullptr : &*found;
}

std::vector<std::uint32_t> idsOf(const std::vector<SegmentedPlane>& planes)
{
  std::vector<std::uint32_t> ids;
  for (const SegmentedPlane& plane : planes) ids.push_back(plane.id);
  return ids;
}

/// Boards before nothing, each 20 cm farther than the last.
PlaneScene boards(const std::vector<test::Pixels>& all)
{
  PlaneScene scene;
  float distance = 1.0F;
  for (const test::Pixels& board : all) {
    paint(scene, board, distance);
    distance += 0.2F;
  }
  return scene;
}

TEST(PlaneSegmentation, ListsTheLargestFirst)
{
  Stage stage;
  const auto& planes = stage.see(boards({around(1, 6, 2, 9), around(10, 20, 2, 20), around(24, 30, 2, 12)}));
  ASSERT_EQ(planes.size(), 3U);
  EXPECT_EQ(planes[0].sample_count, 209U);
  EXPECT_EQ(planes[1].sample_count, 77U);
  EXPECT_EQ(planes[2].sample_count, 48U);
  EXPECT_NEAR(planes[0].plane.distance, 1.2, 1e-4);
  EXPECT_NEAR(planes[1].plane.distance, 1.4, 1e-4);
  EXPECT_NEAR(planes[2].plane.distance, 1.0, 1e-4);
  for (const SegmentedPlane& plane : planes) {
    EXPECT_GE(plane.vertex_count, 3U);
    for (const auto& vertex : stage.boundaryOf(plane))
      EXPECT_NEAR(vertex.z(), plane.plane.distance, 1e-4) << "each has its own boundary";
  }
}

TEST(PlaneSegmentation, WhatHasLessThanTheLeastShareIsLeftOut)
{
  // 0.01 of 1024 samples are 10.24: 12 are listed, and with a share of 0.012, 12.3, they are not.
  const PlaneScene scene = boards({around(4, 7, 4, 6), around(12, 20, 4, 12)});
  PlaneSegmentation::Parameters parameters;
  ASSERT_EQ(parameters.least_share, 0.01);
  EXPECT_EQ(Stage(parameters).see(scene).size(), 2U);
  parameters.least_share = 0.012;
  EXPECT_EQ(Stage(parameters).see(scene).size(), 1U);
}

TEST(PlaneSegmentation, PiecesOfOneWallHaveOneFitAndAnIdEach)
{
  PlaneScene scene(160, 120, test::kFocalLength, 0.0019);
  scene.add(wallAt(1.0), [](const Eigen::Vector3d& p) { return std::abs(p.x()) > 0.15; });
  Stage stage;
  const auto& planes = stage.see(scene);
  ASSERT_EQ(planes.size(), 2U);
  EXPECT_EQ(planes[0].plane.normal, planes[1].plane.normal);
  EXPECT_EQ(planes[0].plane.distance, planes[1].plane.distance);
  EXPECT_EQ(planes[0].covariance, planes[1].covariance);
  EXPECT_NE(planes[0].id, planes[1].id);
  EXPECT_GT(stage.boundaryOf(planes[0])[0].x() * -stage.boundaryOf(planes[1])[0].x(), 0.0)
      << "one is on the left, the other on the right";
}

TEST(PlaneSegmentation, TellsFloorLevelUprightAndSloped)
{
  // From 1 m above the floor, pitched down: a wall 3 m ahead, a table top and a roof of 30 degrees.
  const geometry::Plane floor = test::floorSeenFrom(1.0, 0.5);
  const Eigen::AngleAxisd pitch(0.5, Eigen::Vector3d::UnitX());
  const Eigen::Vector3d wall = pitch * -Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d roof =
      Eigen::AngleAxisd(30 * kDegree, pitch * Eigen::Vector3d::UnitZ()) * floor.normal;
  PlaneScene scene(160, 120, 100.0, 0.002);
  const auto ahead = [&](const Eigen::Vector3d& p) { return -wall.dot(p); };
  scene.add(floor);
  scene.add({wall, 3.0});
  scene.add(test::raised(floor, 0.6),
            [&](const Eigen::Vector3d& p) { return p.x() < -0.1 && ahead(p) > 0.7 && ahead(p) < 1.6; });
  scene.add({roof, 0.5},
            [&](const Eigen::Vector3d& p) { return p.x() > 0.2 && ahead(p) > 0.9 && ahead(p) < 1.5; });
  Stage stage;
  const auto& planes = stage.see(scene);
  ASSERT_EQ(stage.tracker.state().status, FloorStatus::kFound);
  const auto kindAt = [&](const Eigen::Vector3d& normal, double distance) {
    for (const SegmentedPlane& plane : planes) {
      if (geometry::angleBetween(plane.plane.normal, normal) < 2 * kDegree &&
          std::abs(plane.plane.distance - distance) < 0.03)
        return static_cast<int>(plane.kind);
    }
    return -1;
  };
  EXPECT_EQ(kindAt(floor.normal, 1.0), static_cast<int>(PlaneKind::kFloor));
  EXPECT_EQ(kindAt(floor.normal, 0.4), static_cast<int>(PlaneKind::kHorizontal)) << "the table top";
  EXPECT_EQ(kindAt(wall, 3.0), static_cast<int>(PlaneKind::kVertical));
  EXPECT_EQ(kindAt(roof, 0.5), static_cast<int>(PlaneKind::kSloped));
}

TEST(PlaneSegmentation, TheKindIsByTheAngleToUp)
{
  PlaneScene scene;
  scene.add(wallAt(1.0));
  const auto kindFor = [&](double degrees) {
    // Up in the image's plane, turned towards the camera by that.
    const Eigen::Vector3d up = Eigen::AngleAxisd(degrees * kDegree, Eigen::Vector3d::UnitX()) * kUp;
    Stage stage;
    const auto& planes = stage.see(scene);
    EXPECT_TRUE(planes.size() == 1 && planes[0].kind == PlaneKind::kUnknown) << "without up";
    stage.grid.update(scene.view());
    stage.segmentation.segment(scene.view(), stage.grid, stage.tracker.detector(), FloorState{}, up,
                               stage.seen);
    return stage.seen.planes.at(0).kind;
  };
  EXPECT_EQ(kindFor(0.0), PlaneKind::kVertical);
  EXPECT_EQ(kindFor(2.5), PlaneKind::kVertical) << "2.9 degrees are allowed";
  EXPECT_EQ(kindFor(-2.5), PlaneKind::kVertical);
  EXPECT_EQ(kindFor(3.3), PlaneKind::kSloped);
  EXPECT_EQ(kindFor(-45.0), PlaneKind::kSloped);
  EXPECT_EQ(kindFor(86.7), PlaneKind::kSloped);
  EXPECT_EQ(kindFor(87.5), PlaneKind::kHorizontal);
  EXPECT_EQ(kindFor(-90.0), PlaneKind::kHorizontal) << "a ceiling is level, too";
}

TEST(PlaneSegmentation, TheFloorsEntryIsTheFloorState)
{
  PlaneScene scene(160, 120, test::kFocalLength, 0.003);
  scene.add(test::floorSeenFrom(0.8, 0.6, 0.1));
  Stage stage;
  const auto& planes = stage.see(scene);
  const FloorState& floor = stage.tracker.state();
  ASSERT_EQ(floor.status, FloorStatus::kFound);
  ASSERT_EQ(planes.size(), 1U);
  EXPECT_EQ(planes[0].kind, PlaneKind::kFloor);
  EXPECT_EQ(planes[0].plane.normal, floor.floor.plane.normal);
  EXPECT_EQ(planes[0].plane.distance, floor.floor.plane.distance);
  EXPECT_EQ(planes[0].rms_error, floor.floor.rms_error);
  EXPECT_EQ(planes[0].covariance, floor.floor.covariance);
}

TEST(PlaneSegmentation, WithoutAFloorInTheFrameNoneIsListed)
{
  PlaneScene scene;
  scene.add(test::floorSeenFrom(0.8, 0.6));
  Stage stage;
  stage.see(scene);
  FloorState held = stage.tracker.state();
  held.status = FloorStatus::kHeld;
  stage.segmentation.segment(scene.view(), stage.grid, stage.tracker.detector(), held,
                             held.floor.plane.normal, stage.seen);
  ASSERT_EQ(stage.seen.planes.size(), 1U);
  EXPECT_EQ(stage.seen.planes[0].kind, PlaneKind::kHorizontal);
}

/// A room's corner as a camera that turns and sinks slowly sees it.
PlaneScene cornerFrom(double yaw, double sink)
{
  const Eigen::AngleAxisd turn(yaw, Eigen::Vector3d::UnitY());
  PlaneScene scene(160, 120, 100.0, 0.002);
  scene.add({kUp, 1.0 - sink});
  scene.add({turn * Eigen::Vector3d(1.0, 0.0, -1.0).normalized(), 1.5});
  scene.add({turn * Eigen::Vector3d(-1.0, 0.0, -1.0).normalized(), 1.5});
  return scene;
}

TEST(PlaneSegmentation, IdsStayWhileTheCameraMoves)
{
  Stage stage;
  const auto idsAt = [&](double yaw, double sink) {
    const auto& planes = stage.see(cornerFrom(yaw, sink));
    std::vector<std::uint32_t> ids;
    const Eigen::AngleAxisd turn(yaw, Eigen::Vector3d::UnitY());
    for (const Eigen::Vector3d& normal :
         {kUp, Eigen::Vector3d(1.0, 0.0, -1.0), Eigen::Vector3d(-1.0, 0.0, -1.0)}) {
      const SegmentedPlane* const plane = withNormal(planes, turn * normal);
      ids.push_back(plane != nullptr ? plane->id : 0);
    }
    return ids;
  };
  const std::vector<std::uint32_t> first = idsAt(-0.3, 0.0);
  EXPECT_EQ(std::set<std::uint32_t>(first.begin(), first.end()), (std::set<std::uint32_t>{1, 2, 3}));
  const std::uint32_t largest = stage.seen.planes[0].id;
  for (int frame = 1; frame <= 20; ++frame)
    EXPECT_EQ(idsAt(-0.3 + 0.03 * frame, 0.02 * frame), first) << "frame " << frame;
  EXPECT_NE(stage.seen.planes[0].id, largest) << "another one is the largest by now";
  stage.segmentation.reset();
  for (const std::uint32_t id : idsAt(0.3, 0.4)) EXPECT_GT(id, 3U) << "after a reset";
}

TEST(PlaneSegmentation, OtherParametersKeepTheIds)
{
  const PlaneScene scene = boards({around(4, 7, 4, 6), around(12, 20, 4, 12)});
  Stage stage;
  stage.see(scene);
  ASSERT_EQ(stage.seen.planes.size(), 2U);
  const std::uint32_t largest = stage.seen.planes[0].id;
  PlaneSegmentation::Parameters parameters;
  parameters.least_share = 0.05;
  stage.segmentation.configure(parameters);
  EXPECT_EQ(idsOf(stage.see(scene)), std::vector<std::uint32_t>{largest});
}

TEST(PlaneSegmentation, WhatThePixelsDoNotHoldOutIsLeftOut)
{
  PlaneSegmentation::Parameters with;
  with.largest_curvature = 1e9;
  PlaneSegmentation::Parameters all = with;
  all.least_support = 0.0;
  PlaneScene scene = test::poleAt(1.5, 0.03);
  scene.add(wallAt(2.5));
  const auto nearest = [](const std::vector<SegmentedPlane>& planes) {
    double distance = 100.0;
    for (const SegmentedPlane& plane : planes) distance = std::min(distance, plane.plane.distance);
    return distance;
  };
  EXPECT_LT(nearest(Stage(all).see(scene)), 1.6) << "samples alone take the pole for a plane";
  EXPECT_NEAR(nearest(Stage(with).see(scene)), 2.5, 0.01) << "the wall behind the pole";
}

TEST(PlaneSegmentation, ALegIsNoPlaneHoweverManyPixelsLieOnIt)
{
  PlaneSegmentation::Parameters all;
  all.largest_curvature = 1e9;
  PlaneScene scene = test::poleAt(0.8, 0.06);
  scene.add(wallAt(2.5));
  const auto near = [](const std::vector<SegmentedPlane>& planes) {
    return std::count_if(planes.begin(), planes.end(),
                         [](const SegmentedPlane& plane) { return plane.plane.distance < 1.0; });
  };
  EXPECT_GE(near(Stage(all).see(scene)), 1) << "the front of the leg, if curvature is allowed";
  EXPECT_EQ(near(Stage().see(scene)), 0);
}

TEST(PlaneSegmentation, APlaneWhoseNormalIsUncertainIsLeftOut)
{
  PlaneScene scene(160, 120, test::kFocalLength, 0.002);
  scene.add(wallAt(1.0));
  PlaneSegmentation::Parameters parameters;
  EXPECT_EQ(Stage(parameters).see(scene).size(), 1U);
  parameters.largest_normal_sigma = 1e-6;
  EXPECT_TRUE(Stage(parameters).see(scene).empty());
}

TEST(PlaneSegmentation, APlaneThroughTheCameraIsNone)
{
  // The pixels of one row lie on a plane through the camera, whatever they are of. Here those are left of two rows.
  PlaneScene scene(34, 16, 37.6);
  const auto set = [&](std::size_t row, std::size_t first, const std::vector<float>& depths) {
    std::copy(depths.begin(), depths.end(),
              scene.depth().begin() + static_cast<std::ptrdiff_t>(34 * row + first));
  };
  set(0, 9, {3.12F, 3.16F, 3.28F, 3.31F, 3.37F});
  set(1, 9, {5.19F, 5.19F, 5.19F, 5.19F, 5.19F});
  set(2, 10, {5.19F, 5.19F, 5.19F});
  Stage stage;
  for (const SegmentedPlane& plane : stage.see(scene))
    EXPECT_GT(plane.plane.distance, 0.03)
        << "0.01 rad of 3 m; with a normal of " << plane.plane.normal.transpose();
}

TEST(PlaneSegmentation, AnImageSmallerThanTheGridHasPlanes)
{
  PlaneScene scene(20, 15, 18.0);
  scene.add(wallAt(1.0));
  Stage stage;
  const auto& planes = stage.see(scene);
  ASSERT_EQ(planes.size(), 1U);
  EXPECT_EQ(planes[0].sample_count, 300U) << "a sample a pixel";
  EXPECT_NEAR(planes[0].plane.distance, 1.0, 1e-5);
}

TEST(PlaneSegmentation, OfNothingSeenNothingIsListed)
{
  Stage stage;
  ASSERT_EQ(stage.see(boards({around(4, 20, 4, 20)})).size(), 1U);
  EXPECT_TRUE(stage.see(PlaneScene()).empty());
  EXPECT_TRUE(stage.seen.vertices.empty());
  for (const auto& [width, height] :
       {std::pair{1U, 1U}, std::pair{1U, 9U}, std::pair{40U, 1U}, std::pair{2U, 2U}}) {
    PlaneScene line(width, height, 20.0);
    EXPECT_TRUE(stage.see(line).empty()) << width << " x " << height;
    line.add(wallAt(1.0));
    EXPECT_TRUE(stage.see(line).empty()) << width << " x " << height;
  }
}

}  // namespace
}  // namespace polygonal_perception::perception

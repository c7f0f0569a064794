#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "polygonal_perception/perception/floor/floor_frame.hpp"
#include "polygonal_perception/perception/pipeline.hpp"
#include "support/plane_scene.hpp"

namespace polygonal_perception::perception {
namespace {

constexpr double kDegree = 0.017453292519943295;

/// A robot that drives along x over a floor at x < 0, up a ramp of 2 m and over the level ground at its top, between
/// walls at y = +-1.2, with a post on each of the three. It stands where the middle of its wheels is, as tilted as the ground
/// there.
class SlopedWay
{
public:
  explicit SlopedWay(double slope) : slope_(slope) {}

  double groundAt(double x) const { return std::tan(slope_) * std::clamp(x, 0.0, kLength); }
  double slopeAt(double x) const { return x >= 0.0 && x < kLength ? slope_ : 0.0; }

  /// What a camera sees 0.8 m above a robot at x, pitched by 0.35 against the robot.
  test::PlaneScene seenFrom(double x) const
  {
    test::PlaneScene scene(160, 120, 142.5, 0.002);
    const auto place = [this, x](const Eigen::Vector3d& p) { return inWorld(p, x); };
    const double rise = groundAt(kLength);
    add(scene, x, {0.0, 0.0, 1.0}, 0.0, [place](const Eigen::Vector3d& p) { return place(p).x() < 0.0; });
    add(scene, x, {-std::sin(slope_), 0.0, std::cos(slope_)}, 0.0,
        [place](const Eigen::Vector3d& p) { return place(p).x() >= 0.0 && place(p).x() < kLength; });
    add(scene, x, {0.0, 0.0, 1.0}, -rise,
        [place](const Eigen::Vector3d& p) { return place(p).x() >= kLength; });
    for (const double side : {-1.0, 1.0}) {
      add(scene, x, {0.0, -side, 0.0}, kHalfWidth,
          [place, this](const Eigen::Vector3d& p) { return place(p).z() > groundAt(place(p).x()); });
    }
    for (const double post : posts()) {
      add(scene, x, {-1.0, 0.0, 0.0}, post, [place, this](const Eigen::Vector3d& p) {
        const double height = place(p).z() - groundAt(place(p).x());
        return std::abs(place(p).y() - kPostY) < 0.1 && height > 0.0 && height < 0.4;
      });
    }
    return scene;
  }

  static std::array<double, 3> posts() { return {-0.7, 1.3, 3.2}; }

  /// In the optical frame: the plane on which the robot at x stands.
  static geometry::Plane floor() { return test::floorSeenFrom(0.8, kPitch); }

  /// From the floor frame of a robot at x into the world.
  Eigen::Vector3d toWorld(const Eigen::Vector3d& p, double x) const
  {
    const double s = slopeAt(x);
    const Eigen::Vector3d ahead(std::cos(s), 0.0, std::sin(s));
    const Eigen::Vector3d up(-std::sin(s), 0.0, std::cos(s));
    return Eigen::Vector3d(x, 0.0, groundAt(x)) + p.x() * ahead + p.y() * Eigen::Vector3d::UnitY() +
           p.z() * up;
  }

  static constexpr double kHalfWidth = 1.2;
  static constexpr double kPostY = 0.5;

private:
  static constexpr double kLength = 2.0;
  static constexpr double kPitch = 0.35;

  Eigen::Vector3d inWorld(const Eigen::Vector3d& p, double x) const
  {
    return toWorld(floorFrame(floor(), ViewAxes{}) * p, x);
  }

  /// A plane of the world, n . p + d = 0, as the camera sees it.
  void add(test::PlaneScene& scene, double x, const Eigen::Vector3d& normal, double distance,
           const test::PlaneScene::Inside& inside) const
  {
    // From the world into the optical frame: where three points of it go.
    const Eigen::Isometry3d to_floor = floorFrame(floor(), ViewAxes{});
    Eigen::Isometry3d to_world = Eigen::Isometry3d::Identity();
    to_world.translation() = toWorld(Eigen::Vector3d::Zero(), x);
    for (int axis = 0; axis < 3; ++axis)
      to_world.linear().col(axis) = toWorld(Eigen::Vector3d::Unit(axis), x) - to_world.translation();
    const Eigen::Isometry3d from_optical = to_world * to_floor;
    scene.add({from_optical.linear().transpose() * normal, distance + normal.dot(from_optical.translation())},
              inside);
  }

  double slope_;
};

struct Counts
{
  int frames = 0;
  int not_answered = 0;   // no floor in any way
  int off = 0;            // the floor is more than 1 degree or 2 cm off
  int on_ground = 0;      // frames with an occupied cell within 2.5 m where nothing stands
  int on_far_ground = 0;  // the same farther off
  int posts_seen = 0;
  int posts_missed = 0;
};

/// Drives over the way and holds each frame against the truth.
Counts drive(const SlopedWay& way, double max_slope, bool has_mount)
{
  Pipeline::Parameters parameters;
  parameters.ground.max_slope = max_slope;
  Pipeline pipeline(parameters);
  Counts counts;
  for (double x = -3.0; x < 3.5; x += 0.1) {
    const test::PlaneScene scene = way.seenFrom(x);
    FloorHints hints;
    if (has_mount) hints.mount = SlopedWay::floor();
    const Pipeline::Result& result = pipeline.process({scene.view(), 0.2 * ++counts.frames, hints});
    if (result.floor.status == FloorStatus::kNotFound) {
      ++counts.not_answered;
      continue;
    }
    const geometry::Plane truth = SlopedWay::floor();
    const double cosine = result.floor.floor.plane.normal.dot(truth.normal);
    counts.off +=
        cosine < std::cos(kDegree) || std::abs(result.floor.floor.plane.distance - truth.distance) > 0.02;
    bool has_false_cell = false;
    bool has_far_false_cell = false;
    std::array<bool, 3> seen{};
    const occupancy::BinaryGrid& grid = result.occupancy;
    for (int j = 0; j < grid.cellsY(); ++j) {
      for (int i = 0; i < grid.cellsX(); ++i) {
        if (!grid.occupied(i, j)) continue;
        const Eigen::Vector3d cell(grid.geometry().origin_x + (i + 0.5) * 0.05,
                                   grid.geometry().origin_y + (j + 0.5) * 0.05, 0.0);
        const Eigen::Vector3d world = way.toWorld(cell, x);
        bool is_true = std::abs(world.y()) > SlopedWay::kHalfWidth - 0.1;
        for (std::size_t k = 0; k < seen.size(); ++k) {
          const bool is_post = std::abs(world.x() - SlopedWay::posts()[k]) < 0.15 &&
                               std::abs(world.y() - SlopedWay::kPostY) < 0.18;
          seen[k] = seen[k] || is_post;
          is_true = is_true || is_post;
        }
        (cell.x() < 2.5 ? has_false_cell : has_far_false_cell) |= !is_true;
      }
    }
    counts.on_ground += has_false_cell ? 1 : 0;
    counts.on_far_ground += has_far_false_cell ? 1 : 0;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      const double distance = SlopedWay::posts()[k] - x;
      if (distance < 1.6 || distance > 3.5) continue;
      counts.posts_seen += seen[k] ? 1 : 0;
      counts.posts_missed += seen[k] ? 0 : 1;
    }
  }
  return counts;
}

std::string text(const Counts& counts)
{
  return std::to_string(counts.frames) + " frames, not answered " + std::to_string(counts.not_answered) +
         ", off " + std::to_string(counts.off) + ", with cells on the ground " +
         std::to_string(counts.on_ground) + " (far " + std::to_string(counts.on_far_ground) +
         "), posts seen " + std::to_string(counts.posts_seen) + ", missed " +
         std::to_string(counts.posts_missed);
}

TEST(Slopes, ARampIsDrivenUpAndOverWithAMount)
{
  for (const double slope : {4.0, 7.0}) {
    const Counts counts = drive(SlopedWay(slope * kDegree), 10 * kDegree, true);
    EXPECT_EQ(counts.not_answered, 0) << text(counts);
    EXPECT_EQ(counts.off, 0) << text(counts);
    EXPECT_EQ(counts.on_ground, 0) << text(counts);
    // So far away a ramp is a few rows of samples, and not always a plane.
    EXPECT_LE(counts.on_far_ground, counts.frames / 10) << text(counts);
    EXPECT_EQ(counts.posts_missed, 0) << text(counts);
    EXPECT_GT(counts.posts_seen, 30) << text(counts);
  }
}

TEST(Slopes, WithoutAMountTheRampIsGroundAsLongAsTheFloorBeforeItIsSeen)
{
  const Counts counts = drive(SlopedWay(7.0 * kDegree), 10 * kDegree, false);
  EXPECT_EQ(counts.on_ground, 0) << text(counts);
  EXPECT_LE(counts.on_far_ground, counts.frames / 10) << text(counts);
  EXPECT_EQ(counts.posts_missed, 0) << text(counts);
  // At the foot of the ramp and before its crest the other plane fills the view, and is the floor.
  EXPECT_LE(counts.off, counts.frames / 3) << text(counts);
}

TEST(Slopes, ByDefaultARampIsAnObstacle)
{
  const Counts counts = drive(SlopedWay(7.0 * kDegree), 0.0, true);
  EXPECT_GT(counts.on_ground, counts.frames / 10) << text(counts);
}

}  // namespace
}  // namespace polygonal_perception::perception

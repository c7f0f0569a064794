#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "polygonal_perception/cameras/simulation/scene.hpp"

namespace polygonal_perception::simulation {
namespace {

TEST(Scene, SeedsGiveDifferentLayoutsAndTheSameSeedTheSame)
{
  for (const std::string& name : sceneNames()) {
    const Scene one = makeScene(name, 1);
    const Scene again = makeScene(name, 1);
    const Scene other = makeScene(name, 2);
    ASSERT_EQ(one.solids.size(), again.solids.size()) << name;
    for (std::size_t i = 0; i < one.solids.size(); ++i) {
      ASSERT_EQ(one.solids[i].vertices, again.solids[i].vertices) << name;
    }
    EXPECT_TRUE(one.solids.size() != other.solids.size() ||
                one.solids[0].vertices != other.solids[0].vertices)
        << name;
  }
}

TEST(Scene, UnknownNameIsRefusedWithThatName)
{
  try {
    makeScene("swimming_pool", 1);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& e) {
    EXPECT_NE(std::string(e.what()).find("swimming_pool"), std::string::npos) << e.what();
  }
}

TEST(Scene, FloorLiesAtZeroAndTheLowerFloorBelowIt)
{
  for (const std::string& name : sceneNames()) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      bool has_lower = false;
      for (const Solid& solid : makeScene(name, seed).solids) {
        for (const Eigen::Vector3f& p : solid.vertices) {
          // Mats are floor, too.
          if (solid.surface == Surface::kFloor) {
            EXPECT_LE(std::abs(p.z()), 0.01F) << name << ' ' << seed;
          } else if (solid.surface == Surface::kLowerFloor) {
            EXPECT_LT(p.z(), 0.0F) << name << ' ' << seed;
          }
        }
        has_lower |= solid.surface == Surface::kLowerFloor;
      }
      EXPECT_EQ(has_lower, name == "stairs" || name == "ledge") << name;
    }
  }
}

TEST(Scene, WhatIsRaisedBeginsBeforeTheRobotAndIsThreeTo28CentimetresHigh)
{
  for (const char* name : {"dais", "pallet", "kerb", "threshold", "ramp", "carpet"}) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      // Of the large solids that stand on the floor, walls and ceiling aside, the highest vertex.
      float top = 0.0F;
      for (const Solid& solid : makeScene(name, seed).solids) {
        float low = 1e9F;
        float high = -1e9F;
        float area = 0.0F;
        for (const Eigen::Vector3f& p : solid.vertices) {
          low = std::min(low, p.z());
          high = std::max(high, p.z());
          area = std::max(area, (p - solid.vertices[0]).head<2>().norm());
        }
        if (solid.surface == Surface::kObstacle && low < 0.2F && high < 0.3F && area > 0.5F)
          top = std::max(top, high);
      }
      EXPECT_GE(top, 0.03F) << name << ' ' << seed;
      EXPECT_LE(top, 0.285F) << name << ' ' << seed;
    }
  }
}

TEST(Scene, ObstaclesAreThoseOfTheBandAndMoveWithThePeople)
{
  Scene scene;
  scene.solids.push_back(makeBox(Eigen::Isometry3d(Eigen::Translation3d(0, 0, 1.0)), {1, 1, 0.2}));
  EXPECT_TRUE(scene.obstacles(0.0, 0.03, 0.6).empty()) << "the board is at 0.9 m";
  EXPECT_EQ(scene.obstacles(0.0, 0.03, 1.0).size(), 1U);

  scene.walkers.push_back({{5.0, 0.0}, {9.0, 0.0}, 1.0, 0.0, 1.8});
  const auto nearest = [&](double time) {
    double x = 1e9;
    for (const Outline& outline : scene.obstacles(time, 0.03, 0.6)) {
      for (const Eigen::Vector2d& p : outline) x = std::min(x, p.x());
    }
    return x;
  };
  EXPECT_NEAR(nearest(2.0) - nearest(0.0), 2.0, 0.5) << "2 s at 1 m/s, but for the phase of the stride";
}

TEST(Scene, SomebodyWhoWalksStandsOnTheFloor)
{
  const Walker walker{{0, 0}, {10, 0}, 1.2, 0.0, 1.75};
  for (int tenth = 0; tenth < 20; ++tenth) {
    const double time = 0.1 * tenth;
    std::vector<Solid> person;
    addPerson(person, walker.at(time));
    float low = 1e9F;
    float high = -1e9F;
    for (const Solid& solid : person) {
      for (const Eigen::Vector3f& p : solid.vertices) {
        low = std::min(low, p.z());
        high = std::max(high, p.z());
      }
    }
    EXPECT_NEAR(low, 0.0F, 0.01F) << time;
    EXPECT_NEAR(high, 1.75F, 0.15F) << time;
  }
}

TEST(Scene, SomebodyWhoWalksTurnsRoundSmoothly)
{
  const Walker walker{{0, 0}, {2, 1}, 1.0, 0.3, 1.75};
  PersonPose last = walker.at(0.0);
  for (int frame = 1; frame < 300; ++frame) {
    const PersonPose pose = walker.at(frame / 30.0);
    EXPECT_LT((pose.position - last.position).norm(), 1.01 / 30.0) << frame;
    EXPECT_LT(std::abs(std::remainder(pose.yaw - last.yaw, 2.0 * M_PI)), 0.25) << frame;
    last = pose;
  }
  const PersonPose there = walker.at(0.5);
  EXPECT_NEAR(std::remainder(there.yaw - std::atan2(1, 2), 2.0 * M_PI), 0.0, 1e-9);
  const PersonPose back = walker.at(3.0);
  EXPECT_NEAR(std::abs(std::remainder(back.yaw - std::atan2(1, 2), 2.0 * M_PI)), M_PI, 1e-9);
}

TEST(Scene, SomebodyWalksInABusyOfficeAndThroughNothing)
{
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Scene scene = makeScene("busy_office", seed);
    ASSERT_EQ(scene.walkers.size(), 1U);
    const Walker& walker = scene.walkers[0];
    EXPECT_GT((walker.to - walker.from).norm(), 1.0) << seed;
    Scene furniture = scene;
    furniture.walkers.clear();
    for (double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const Eigen::Vector2d place = walker.from + part * (walker.to - walker.from);
      for (const Outline& outline : furniture.obstacles(0.0, 0.05, 2.0)) {
        EXPECT_GT(distanceTo(outline, place), 0.3) << seed;
      }
    }
  }
}

}  // namespace
}  // namespace polygonal_perception::simulation

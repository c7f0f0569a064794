// From plane to plane down to the floor.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "polygonal_perception/geometry/angle.hpp"
#include "support/rated_planes.hpp"

namespace polygonal_perception::test {
namespace {

// --- Steps.

class SelectionAboveStairs : public Selection
{
protected:
  /// Treads of 17 cm; the camera is 0.8 m above the landing.
  SelectionAboveStairs()
  {
    scene_.add(landing_, [](const Eigen::Vector3d& p) { return ahead(p) < 0.9; });
    scene_.add(raised(landing_, -0.17),
               [](const Eigen::Vector3d& p) { return ahead(p) > 0.9 && ahead(p) < 1.7; });
    scene_.add(raised(landing_, -0.34),
               [](const Eigen::Vector3d& p) { return ahead(p) > 1.7 && ahead(p) < 2.9; });
  }

  geometry::Plane landing_ = raised(kFloor, 0.2);
};

TEST_F(SelectionAboveStairs, AStepCosts)
{
  parameters_.step = 8.0;
  parameters_.max_camera_height = 1.05;
  rate();
  EXPECT_TRUE(at(0.97).is_step);
  EXPECT_NEAR(termOf(0.97), -8.0, 1e-9);
  EXPECT_TRUE(at(0.8).leads_down);
  EXPECT_NEAR(termOf(0.8), 0.0, 1e-9);
  EXPECT_NEAR(bestOfRated(), 0.8, 0.01);
}

TEST_F(SelectionAboveStairs, TheLandingIsTheFloorWhereALowerStepCannotBe)
{
  parameters_ = FloorSelectionParameters();
  EXPECT_NEAR(best(), 1.14, 0.05) << "where the camera may be that high, the lowest";
  parameters_.max_camera_height = 1.05;
  EXPECT_NEAR(best(), 0.8, 0.01) << "the landing has a score of " << at(0.8).score << " by " << at(0.8).size
                                 << " samples, the step one of " << at(0.97).score << " by " << at(0.97).size;
  EXPECT_TRUE(at(0.8).leads_down);
}

// --- Down to a lower plane.

class SelectionAboveATable : public Selection
{
protected:
  /// A table top over most of the view, 40 cm above the floor.
  SelectionAboveATable()
  {
    scene_.add(kFloor);
    scene_.add(raised(kFloor, 0.4), [](const Eigen::Vector3d& p) { return p.x() < 0.15; });
  }
};

TEST_F(SelectionAboveATable, TheFloorIsBelow)
{
  parameters_.lower_plane_weight = 3.0;
  rate();
  ASSERT_GT(at(0.6).size, at(1.0).size);
  EXPECT_NEAR(bestOfRated(), 1.0, 0.01);
}

TEST_F(SelectionAboveATable, WithoutWeightTheLowerPlaneIsNotLookedFor)
{
  parameters_.lower_plane_weight = 0.0;
  EXPECT_NEAR(best(), 0.6, 0.01);
}

TEST_F(SelectionAboveATable, EverySampleBelowSpeaksForTheLowerPlane)
{
  // The weight from which on one goes down is what the sizes differ by, over ln(1 + samples below / 6).
  rate();
  const FloorCandidate& floor = at(1.0);
  const double needed = (at(0.6).score - floor.score) / std::log(1.0 + floor.size / 6.0);
  parameters_.lower_plane_weight = 1.02 * needed;
  EXPECT_NEAR(best(), 1.0, 0.01);
  parameters_.lower_plane_weight = 0.98 * needed;
  EXPECT_NEAR(best(), 0.6, 0.01);
}

TEST_F(SelectionAboveATable, WhatTheFloorLosesByOtherTermsCountsToo)
{
  parameters_.lower_plane_weight = 3.0;
  parameters_.other_plane = 30.0;
  prior_.height = 0.6;
  prior_.height_tolerance = 0.06;
  prior_.others.add(-0.4);
  EXPECT_NEAR(best(), 0.6, 0.01) << "the lower plane is known to be none";
}

TEST_F(SelectionAboveATable, WhatIsRefusedIsGivenUpForTheNext)
{
  parameters_ = FloorSelectionParameters();
  rate();
  FloorCandidate* floor = selection_.best(parameters_);
  ASSERT_NE(floor, nullptr);
  ASSERT_NEAR(floor->fit.plane.distance, 1.0, 0.01);
  floor->refused = true;
  FloorCandidate* table = selection_.best(parameters_);
  ASSERT_NE(table, nullptr);
  EXPECT_NEAR(table->fit.plane.distance, 0.6, 0.01);
  table->refused = true;
  EXPECT_EQ(selection_.best(parameters_), nullptr);
}

TEST_F(SelectionAboveATable, APlaneThatIsTooLowIsNotGoneDownTo)
{
  parameters_.lower_plane_weight = 3.0;
  parameters_.max_camera_height = 0.8;
  EXPECT_NEAR(best(), 0.6, 0.01);
}

TEST_F(SelectionAboveATable, TheOtherPlaneIsToldAbout)
{
  rate();
  const PlaneOffsets others = selection_.others(kFloor, parameters_);
  ASSERT_EQ(others.end() - others.begin(), 1);
  EXPECT_NEAR(*others.begin(), 0.4, 0.01) << "the table, above the floor";
  const PlaneOffsets from_table = selection_.others(raised(kFloor, 0.4), parameters_);
  ASSERT_EQ(from_table.end() - from_table.begin(), 1);
  EXPECT_NEAR(*from_table.begin(), -0.4, 0.01) << "the floor, below the table";
  const PlaneOffsets askew =
      selection_.others({Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()) * kFloor.normal, 1.0}, parameters_);
  EXPECT_EQ(askew.end(), askew.begin()) << "nothing is parallel to that";
}

TEST_F(Selection, FromATableOverADaisOneGoesDownToTheFloor)
{
  parameters_.lower_plane_weight = 3.0;
  scene_.add(kFloor);
  scene_.add(raised(kFloor, 0.2), [](const Eigen::Vector3d& p) { return p.x() < 0.25; });
  scene_.add(raised(kFloor, 0.5), [](const Eigen::Vector3d& p) { return p.x() < 0.05; });
  rate();
  ASSERT_EQ(selection_.candidates().size(), 3U);
  ASSERT_GT(at(0.5).size, at(1.0).size);
  EXPECT_NEAR(bestOfRated(), 1.0, 0.01);
}

/// Adds the level plane left of x = 0.1, and right of it one that begins so much lower and falls away to the
/// right.
void addFalling(PlaneScene& scene, double step, double angle)
{
  const Eigen::Vector3d right = Eigen::Vector3d::UnitX();
  const Eigen::Vector3d normal = std::cos(angle) * kFloor.normal + std::sin(angle) * right;
  const Eigen::Vector3d at_edge = -(1.0 + step) * kFloor.normal + 0.1 * right;
  scene.add(kFloor, [](const Eigen::Vector3d& p) { return p.x() < 0.1; });
  scene.add({normal, -normal.dot(at_edge)}, [](const Eigen::Vector3d& p) { return p.x() >= 0.1; });
}

TEST_F(Selection, APlaneThatIsNotParallelIsNotBelow)
{
  // It lies below all of the level one, by half a metre and more.
  parameters_.lower_plane_weight = 30.0;
  addFalling(scene_, 0.5, 20 * kDegree);
  rate();
  ASSERT_EQ(selection_.candidates().size(), 2U);
  EXPECT_NEAR(bestOfRated(), 1.0, 0.01);
  scene_ = PlaneScene();
  addFalling(scene_, 0.5, 5 * kDegree);
  rate();
  ASSERT_EQ(selection_.candidates().size(), 2U);
  EXPECT_GT(bestOfRated(), 1.4) << "one that is nearly parallel is";
}

TEST_F(Selection, OfTwoPlanesThatCrossNoneIsBelow)
{
  // The right one falls away below the level one, and the level one lies below the right one's plane, with
  // more samples.
  parameters_.lower_plane_weight = 30.0;
  addFalling(scene_, 0.0, 8 * kDegree);
  // A box, so that who went to and fro between the two would not come back to where he began.
  scene_.add(raised(kFloor, 0.3), [](const Eigen::Vector3d& p) { return p.x() < -0.3 && ahead(p) < 0.8; });
  rate();
  ASSERT_EQ(selection_.candidates().size(), 3U);
  const auto& candidates = selection_.candidates();
  EXPECT_TRUE(std::all_of(candidates.begin(), candidates.end(), [&](const FloorCandidate& candidate) {
    return candidate.size <= at(1.0).size;
  })) << "the level plane has the most samples";
  EXPECT_NEAR(bestOfRated(), 1.0, 0.001);
}

// --- Ramps.

class SelectionBeforeARamp : public Selection
{
protected:
  /// A floor that rises by 8 degrees from 0.85 m ahead: most of what is seen is the ramp.
  void addRamp(double angle)
  {
    const Eigen::Vector3d up = std::cos(angle) * kFloor.normal - std::sin(angle) * kAhead;
    const Eigen::Vector3d foot = 0.85 * kAhead - kFloor.normal;
    scene_.add(kFloor, [](const Eigen::Vector3d& p) { return ahead(p) < 0.85; });
    scene_.add({up, -up.dot(foot)}, [](const Eigen::Vector3d& p) { return ahead(p) >= 0.85; });
  }

  /// The angle of what is taken for the floor [rad].
  double angleOfBest()
  {
    rate();
    const FloorCandidate* floor = selection_.best(parameters_);
    return floor == nullptr ? -1.0 : geometry::angleBetween(floor->fit.plane.normal, kFloor.normal);
  }
};

TEST_F(SelectionBeforeARamp, TheNearerPlaneIsTheFloor)
{
  addRamp(8 * kDegree);
  EXPECT_NEAR(angleOfBest() / kDegree, 8.0, 0.5) << "the ramp is larger";
  ASSERT_EQ(selection_.candidates().size(), 2U);
  parameters_.nearer = 2.0;
  EXPECT_NEAR(angleOfBest() / kDegree, 0.0, 0.5);
}

TEST_F(SelectionBeforeARamp, ARampThatLeadsDownIsNotTheFloorForBeingFarther)
{
  // The farther plane falls from the edge: the nearer one may be a ramp down to it, and is not preferred.
  addRamp(-8 * kDegree);
  ASSERT_NEAR(angleOfBest() / kDegree, 8.0, 0.5);
  parameters_.nearer = 20.0;
  EXPECT_NEAR(angleOfBest() / kDegree, 8.0, 0.5);
}

TEST_F(SelectionBeforeARamp, OneGoesOnFromPlaneToPlane)
{
  // From a steep ramp to the platform at its foot, and from there to the floor 0.4 m below the platform. The
  // floor is not parallel to the ramp, which alone would not lead there.
  const geometry::Plane platform = raised(kFloor, 0.4);
  const Eigen::Vector3d up = std::cos(12 * kDegree) * kFloor.normal - std::sin(12 * kDegree) * kAhead;
  const Eigen::Vector3d foot = 0.5 * kAhead - platform.distance * kFloor.normal;
  const auto on_platform = [](const Eigen::Vector3d& p) { return p.x() < 0.2 * p.z(); };
  scene_.add(kFloor);
  scene_.add(platform, [&](const Eigen::Vector3d& p) { return on_platform(p) && ahead(p) < 0.5; });
  scene_.add({up, -up.dot(foot)},
             [&](const Eigen::Vector3d& p) { return on_platform(p) && ahead(p) >= 0.5; });
  EXPECT_NEAR(angleOfBest() / kDegree, 12.0, 0.5) << "the ramp is the largest";
  ASSERT_EQ(selection_.candidates().size(), 3U);
  parameters_.nearer = 5.0;
  EXPECT_NEAR(best(), 0.6, 0.01) << "the platform is nearer";
  parameters_.lower_plane_weight = 3.0;
  EXPECT_NEAR(best(), 1.0, 0.01) << "the floor is below the platform";
}

TEST_F(Selection, TheOrderOfCandidatesDoesNotMatter)
{
  // Mirrored pictures have their planes in another order.
  const auto orderOf = [this] {
    std::vector<int> order;
    for (const FloorCandidate& candidate : selection_.candidates())
      order.push_back(static_cast<int>(std::lround(10.0 * candidate.fit.plane.distance)));
    return order;
  };
  std::vector<std::vector<int>> orders;
  for (const bool mirrored : {false, true}) {
    for (const bool all_terms : {false, true}) {
      parameters_ = all_terms ? FloorSelectionParameters() : onlySupport();
      const auto side = [mirrored](double end) {
        return [=](const Eigen::Vector3d& p) { return (mirrored ? -p.x() : p.x()) < end; };
      };
      scene_ = PlaneScene();
      scene_.add(kFloor);
      scene_.add(raised(kFloor, 0.2), side(0.25));
      scene_.add(raised(kFloor, 0.5), side(0.05));
      const double floor = best();
      EXPECT_NEAR(floor, all_terms ? 1.0 : 0.5, 0.01)
          << (mirrored ? "mirrored" : "as it is") << (all_terms ? ", all terms" : ", only support");
      orders.push_back(orderOf());
    }
  }
  EXPECT_NE(orders.front(), orders.back())
      << "both pictures have their planes in one order: the test tests nothing";
}

}  // namespace
}  // namespace polygonal_perception::test

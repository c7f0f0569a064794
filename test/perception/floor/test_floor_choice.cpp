#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "perception/floor/floor_choice.hpp"

namespace polygonal_perception::perception {
namespace {

constexpr double kLowestPossible = 2.7;  // [m]

/// A level plane at a distance under the camera, all on its own.
FloorCandidate plane(double distance, double ground_range = 1.0)
{
  FloorCandidate candidate;
  candidate.plane.distance = distance;
  candidate.ground_range = ground_range;
  candidate.counts.inliers = 100;
  candidate.lowest = true;
  return candidate;
}

TEST(AngleBetween, IsThatOfVectorsOfAnyLength)
{
  EXPECT_NEAR(angleBetween({2, 0, 0}, {0, 0, 5}), M_PI / 2, 1e-12);
  EXPECT_NEAR(angleBetween({1, 0, 0}, {-3, 0, 0}), M_PI, 1e-12);
  EXPECT_NEAR(angleBetween({1, 0, 0}, {1, 1e-9, 0}), 1e-9, 1e-15) << "small angles keep their digits";
}

/// A robot on a landing 0.8 m under the camera, before stairs of 17 cm that lead down.
class Stairs : public testing::Test
{
protected:
  enum
  {
    kLanding,
    kStep
  };

  void rejectSteps() { rejectStairSteps(candidates_, too_low_); }

  std::vector<FloorCandidate> candidates_ = {plane(0.8, 1.0), plane(0.97, 1.3)};
  std::vector<FloorCandidate> too_low_ = {plane(1.14, 1.6)};
};

TEST_F(Stairs, AStepIsRefusedAndTheLandingMarked)
{
  rejectSteps();
  EXPECT_TRUE(candidates_[kStep].refused);
  EXPECT_FALSE(candidates_[kStep].is_stair_top);
  EXPECT_FALSE(candidates_[kLanding].refused);
  EXPECT_TRUE(candidates_[kLanding].is_stair_top);
  ASSERT_EQ(too_low_.size(), 2U) << "the step is too low from now on";
  EXPECT_EQ(too_low_[1].plane.distance, 0.97);
}

TEST_F(Stairs, ARefusedStepShowsThatTheNextIsOne)
{
  candidates_ = {plane(0.8, 1.0), plane(1.14, 1.6), plane(0.97, 1.3)};
  too_low_ = {plane(1.31, 1.9)};
  rejectSteps();
  EXPECT_TRUE(candidates_[1].refused) << "the lower one";
  EXPECT_TRUE(candidates_[2].refused) << "the upper one";
  EXPECT_FALSE(candidates_[0].refused) << "the landing";
}

TEST_F(Stairs, WithNothingTooLowThereAreNoSteps)
{
  too_low_.clear();
  rejectSteps();
  EXPECT_FALSE(candidates_[kStep].refused);
}

TEST_F(Stairs, WithNothingAboveAPlaneIsNoStep)
{
  candidates_.erase(candidates_.begin());
  rejectSteps();
  EXPECT_FALSE(candidates_[0].refused);
  EXPECT_EQ(too_low_.size(), 1U);
}

TEST_F(Stairs, RisesDifferByThreeCentimetresAtMost)
{
  candidates_[kLanding].plane.distance = 0.97 - 0.21;
  rejectSteps();
  EXPECT_FALSE(candidates_[kStep].refused) << "17 and 21 cm";
  candidates_[kLanding].plane.distance = 0.97 - 0.19;
  rejectSteps();
  EXPECT_TRUE(candidates_[kStep].refused) << "17 and 19 cm";
}

TEST_F(Stairs, ARiseIsTenToTwentyFiveCentimetres)
{
  const auto isStepAtRiseOf = [this](double rise) {
    candidates_[kStep].refused = false;
    candidates_[kLanding].plane.distance = candidates_[kStep].plane.distance - rise;
    too_low_ = {plane(candidates_[kStep].plane.distance + rise, 1.6)};
    rejectSteps();
    return candidates_[kStep].refused;
  };
  EXPECT_FALSE(isStepAtRiseOf(0.09));
  EXPECT_TRUE(isStepAtRiseOf(0.11));
  EXPECT_TRUE(isStepAtRiseOf(0.24));
  EXPECT_FALSE(isStepAtRiseOf(0.26));
}

TEST_F(Stairs, WhatLiesLowerLiesFartherAway)
{
  // What a shiny floor mirrors of something low lies nearer than the step that it would be.
  too_low_[0].ground_range = 1.2;
  rejectSteps();
  EXPECT_FALSE(candidates_[kStep].refused);
}

TEST_F(Stairs, StepsAreParallel)
{
  too_low_[0].plane.normal = {std::sin(0.15), 0.0, std::cos(0.15)};
  rejectSteps();
  EXPECT_FALSE(candidates_[kStep].refused);
}

/// Candidates of a frame, and which of them is taken for the floor.
class FloorChoice : public testing::Test
{
protected:
  /// The distance of the floor; 0: none.
  double chosen()
  {
    const FloorCandidate* best = mostLikelyFloor(candidates_, prior_, kLowestPossible);
    return best == nullptr ? 0.0 : best->plane.distance;
  }
  /// The same whichever candidate comes first.
  double chosenOfTwo()
  {
    const double first = chosen();
    std::swap(candidates_[0], candidates_[1]);
    EXPECT_EQ(chosen(), first) << "the order of candidates decides";
    std::swap(candidates_[0], candidates_[1]);
    return first;
  }

  std::vector<FloorCandidate> candidates_;
  FloorPrior prior_;
};

TEST_F(FloorChoice, OfNoneThereIsNone)
{
  EXPECT_EQ(chosen(), 0.0);
}

TEST_F(FloorChoice, WhatIsRefusedStaysRefused)
{
  candidates_ = {plane(1.0)};
  EXPECT_EQ(chosen(), 1.0);
  candidates_[0].refused = true;
  EXPECT_EQ(chosen(), 0.0);
}

TEST_F(FloorChoice, APlaneOverOthersIsNone)
{
  candidates_ = {plane(1.0)};
  candidates_[0].lowest = false;
  EXPECT_EQ(chosen(), 0.0);
}

TEST_F(FloorChoice, ButTheTopOfAStaircaseMayBe)
{
  candidates_ = {plane(1.0)};
  candidates_[0].lowest = false;
  candidates_[0].is_stair_top = true;
  EXPECT_EQ(chosen(), 1.0);
}

TEST_F(FloorChoice, AndTheLastFloorMayBeWhereItIsConfirmed)
{
  candidates_ = {plane(1.0)};
  candidates_[0].lowest = false;
  candidates_[0].continues = true;
  EXPECT_EQ(chosen(), 0.0);
  prior_.confirmed = true;
  EXPECT_EQ(chosen(), 1.0);
}

TEST_F(FloorChoice, WhatWasAnotherPlaneIsNoFloor)
{
  candidates_ = {plane(1.0)};
  candidates_[0].matches_other_plane = true;
  EXPECT_EQ(chosen(), 0.0);
}

TEST_F(FloorChoice, MoreSamplesWin)
{
  candidates_ = {plane(1.0), plane(1.2)};
  candidates_[0].counts.inliers = 110;
  EXPECT_EQ(chosenOfTwo(), 1.0);
  candidates_[1].counts.inliers = 120;
  EXPECT_EQ(chosenOfTwo(), 1.2);
}

TEST_F(FloorChoice, ATiltCosts)
{
  candidates_ = {plane(1.0), plane(1.2)};
  candidates_[0].counts.inliers = 200;
  candidates_[0].tilt = 0.3;
  EXPECT_EQ(chosenOfTwo(), 1.0);
  candidates_[0].tilt = 0.5;
  EXPECT_EQ(chosenOfTwo(), 1.2);
}

TEST_F(FloorChoice, ANormalThatNoSampleHasCosts)
{
  candidates_ = {plane(1.0), plane(1.2)};
  candidates_[0].counts.inliers = 200;
  candidates_[0].disagreement = 0.03;
  EXPECT_EQ(chosenOfTwo(), 1.0);
  candidates_[0].disagreement = 0.06;
  EXPECT_EQ(chosenOfTwo(), 1.2);
}

TEST_F(FloorChoice, TheLastFloorComesFirstWhereItIsConfirmed)
{
  candidates_ = {plane(1.0), plane(1.2)};
  candidates_[0].continues = true;
  candidates_[1].counts.inliers = 500;
  EXPECT_EQ(chosenOfTwo(), 1.2);
  prior_.confirmed = true;
  EXPECT_EQ(chosenOfTwo(), 1.0);
}

TEST_F(FloorChoice, OfTwoWhereTheLastFloorWasMoreSamplesWin)
{
  prior_.confirmed = true;
  candidates_ = {plane(1.0), plane(1.03)};
  for (FloorCandidate& candidate : candidates_) candidate.continues = true;
  candidates_[0].counts.inliers = 101;
  candidates_[0].counts.below = 90;  // even where most of the other lies under it
  EXPECT_EQ(chosenOfTwo(), 1.0);
}

TEST_F(FloorChoice, AFewSamplesUnderAPlaneAreTheFloor)
{
  // A table top, and a strip of floor that is seen under it.
  candidates_ = {plane(0.4), plane(1.1)};
  candidates_[0].counts = {600, 20};
  candidates_[1].counts = {30, 0};
  EXPECT_EQ(chosenOfTwo(), 1.1);
}

TEST_F(FloorChoice, APlaneThatOnlyReachesLowerIsNotUnder)
{
  // A steep fit through a wall's foot lies farther from the camera, but hardly any of it below the floor.
  candidates_ = {plane(1.0), plane(1.6)};
  candidates_[0].counts = {600, 10};
  candidates_[1].counts = {30, 0};
  EXPECT_EQ(chosenOfTwo(), 1.0);
}

TEST_F(FloorChoice, UnderTheLowestPossibleFloorNothingIsMeant)
{
  candidates_ = {plane(kLowestPossible + 0.1), plane(kLowestPossible + 0.2)};
  candidates_[0].counts = {600, 30};
  candidates_[1].counts = {30, 0};
  EXPECT_EQ(chosenOfTwo(), kLowestPossible + 0.1);
}

}  // namespace
}  // namespace polygonal_perception::perception

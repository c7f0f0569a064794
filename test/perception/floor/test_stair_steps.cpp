#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "perception/floor/stair_steps.hpp"

namespace polygonal_perception::perception {
namespace {

/// A level plane at a distance [m] under the camera, whose middle lies so far ahead [m].
FloorCandidate plane(double distance, double middle)
{
  FloorCandidate candidate;
  candidate.fit.plane = {Eigen::Vector3d::UnitZ(), distance};
  candidate.fit.centre = {middle, 0.0, -distance};
  candidate.middle = middle;
  candidate.size = 100;
  return candidate;
}

FloorCandidate tooLow(double distance, double middle)
{
  FloorCandidate candidate = plane(distance, middle);
  candidate.too_low = true;
  return candidate;
}

/// A robot on a landing 0.8 m under the camera, before stairs of 17 cm that lead down. The third step is too
/// low.
class Stairs : public testing::Test
{
protected:
  enum
  {
    kLanding,
    kStep,
    kTooLow
  };

  void mark() { markStairSteps(candidates_, parameters_); }

  /// Whether the step is marked, when all was unmarked before.
  bool isStep()
  {
    for (FloorCandidate& candidate : candidates_) candidate.is_step = candidate.leads_down = false;
    mark();
    return candidates_[kStep].is_step;
  }

  FloorSelectionParameters parameters_;
  std::vector<FloorCandidate> candidates_ = {plane(0.8, 1.0), plane(0.97, 1.3), tooLow(1.14, 1.6)};
};

TEST_F(Stairs, AStepIsMarkedAndTheLandingLeadsDown)
{
  mark();
  EXPECT_TRUE(candidates_[kStep].is_step);
  EXPECT_FALSE(candidates_[kStep].leads_down) << "nothing below the step is a step";
  EXPECT_FALSE(candidates_[kLanding].is_step) << "the robot stands on it";
  EXPECT_TRUE(candidates_[kLanding].leads_down);
  EXPECT_FALSE(candidates_[kTooLow].is_step) << "it is no floor anyway";
}

TEST_F(Stairs, AMarkedStepShowsThatTheNextIsOneInWhateverOrder)
{
  const std::vector<FloorCandidate> stairs = {plane(0.8, 1.0), plane(0.97, 1.3), plane(1.14, 1.6),
                                              tooLow(1.31, 1.9)};
  std::vector<std::size_t> order = {0, 1, 2, 3};
  do {
    candidates_.clear();
    for (const std::size_t k : order) candidates_.push_back(stairs[k]);
    mark();
    for (const FloorCandidate& candidate : candidates_) {
      const double height = candidate.fit.plane.distance;
      EXPECT_EQ(candidate.is_step, height == 0.97 || height == 1.14)
          << "the plane at " << height << " m, in the order " << order[0] << order[1] << order[2] << order[3];
      EXPECT_EQ(candidate.leads_down, height == 0.8 || height == 0.97)
          << "the plane at " << height << " m, in the order " << order[0] << order[1] << order[2] << order[3];
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST_F(Stairs, WithNothingTooLowThereAreNoSteps)
{
  candidates_[kTooLow].too_low = false;
  EXPECT_FALSE(isStep()) << "all three may be the floor";
  candidates_.pop_back();
  EXPECT_FALSE(isStep());
}

TEST_F(Stairs, WithNothingAboveAPlaneIsNoStep)
{
  candidates_.erase(candidates_.begin());
  mark();
  EXPECT_FALSE(candidates_[0].is_step);
}

TEST_F(Stairs, WhatIsTooLowItselfIsNoLanding)
{
  candidates_[kLanding].too_low = true;
  EXPECT_FALSE(isStep());
}

TEST_F(Stairs, RisesDifferByThreeCentimetresAtMost)
{
  candidates_[kLanding] = plane(0.97 - 0.21, 1.0);
  EXPECT_FALSE(isStep()) << "17 and 21 cm";
  candidates_[kLanding] = plane(0.97 - 0.19, 1.0);
  EXPECT_TRUE(isStep()) << "17 and 19 cm";
}

TEST_F(Stairs, ARiseIsTenToTwentyFiveCentimetres)
{
  for (const auto& [rise, expected] :
       {std::pair{0.09, false}, std::pair{0.11, true}, std::pair{0.24, true}, std::pair{0.26, false}}) {
    candidates_ = {plane(0.97 - rise, 1.0), plane(0.97, 1.3), tooLow(0.97 + rise, 1.6)};
    EXPECT_EQ(isStep(), expected) << "a rise of " << rise << " m";
  }
}

TEST_F(Stairs, WhatLiesLowerLiesFartherAway)
{
  // What a shiny floor mirrors of something low lies nearer than the step that it would be.
  candidates_[kTooLow] = tooLow(1.14, 1.2);
  EXPECT_FALSE(isStep()) << "the lowest is nearer than the step";
  candidates_[kTooLow] = tooLow(1.14, 1.6);
  candidates_[kLanding] = plane(0.8, 1.4);
  EXPECT_FALSE(isStep()) << "the landing is farther than the step";
}

TEST_F(Stairs, StepsAreParallel)
{
  const auto tilt = [this](double angle) {
    // Turned about the middle of the plane.
    candidates_[kTooLow].fit.plane.normal = {0.0, std::sin(angle), std::cos(angle)};
    candidates_[kTooLow].fit.plane.distance =
        -candidates_[kTooLow].fit.plane.normal.dot(candidates_[kTooLow].fit.centre);
    return isStep();
  };
  EXPECT_FALSE(tilt(0.15));
  EXPECT_TRUE(tilt(0.05));
}

TEST_F(Stairs, TheRiseIsTakenWhereTheLowerPlaneIsSeen)
{
  // The landing leans by 2.9 degrees, so that its distance from the camera is 5 cm less; over the step it is
  // as high as ever.
  FloorCandidate& landing = candidates_[kLanding];
  landing.fit.plane.normal = {std::sin(0.05), 0.0, std::cos(0.05)};
  landing.fit.plane.distance = -landing.fit.plane.normal.dot(Eigen::Vector3d(1.3, 0.0, -0.8));
  ASSERT_LT(landing.fit.plane.distance, 0.75);
  EXPECT_TRUE(isStep());
}

TEST_F(Stairs, OfNoneNothingIsMarked)
{
  candidates_.clear();
  mark();
  EXPECT_TRUE(candidates_.empty());
}

}  // namespace
}  // namespace polygonal_perception::perception

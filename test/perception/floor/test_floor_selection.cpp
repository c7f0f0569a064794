// Each term of the score alone.
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

// --- Which planes are candidates.

TEST_F(Selection, ABareFloorIsTheFloor)
{
  parameters_ = FloorSelectionParameters();
  scene_.add(kFloor);
  EXPECT_NEAR(best(), 1.0, 1e-3);
  const FloorCandidate* floor = selection_.best(parameters_);
  ASSERT_NE(floor, nullptr);
  EXPECT_LT(geometry::angleBetween(floor->fit.plane.normal, kFloor.normal), 1e-3);
  EXPECT_EQ(floor->size, 32U * 32U);
  EXPECT_EQ(floor->scatter, 0.0);
  EXPECT_FALSE(floor->continues) << "nothing was known";
  EXPECT_FALSE(floor->too_low || floor->is_step || floor->is_other_plane || floor->leads_down);
}

TEST_F(Selection, AFrameWithoutReturnsHasNone)
{
  EXPECT_EQ(best(), 0.0);
  EXPECT_TRUE(selection_.candidates().empty());
}

TEST_F(Selection, AWallAndACeilingAreNone)
{
  parameters_ = FloorSelectionParameters();
  prior_.up = -Eigen::Vector3d::UnitY();
  for (const Eigen::Vector3d& normal :
       {Eigen::Vector3d(-Eigen::Vector3d::UnitZ()), Eigen::Vector3d(Eigen::Vector3d::UnitY())}) {
    scene_ = PlaneScene();
    scene_.add({normal, 1.0});
    EXPECT_EQ(best(), 0.0) << "normal " << normal.transpose();
    ASSERT_EQ(extraction_.planes().size(), 1U) << "normal " << normal.transpose();
    EXPECT_FALSE(selection_.isCandidate(0)) << "normal " << normal.transpose();
  }
}

TEST_F(Selection, TheTiltFromASeedMayBeGreaterThanFromAMeasuredUp)
{
  scene_.add(kFloor);
  const auto isFloorTiltedBy = [this](double tilt) {
    prior_.up = Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitX()) * kFloor.normal;
    return best() > 0.0;
  };
  const double most = parameters_.max_tilt;
  EXPECT_TRUE(isFloorTiltedBy(most + 0.14));
  EXPECT_FALSE(isFloorTiltedBy(most + 0.16));
  prior_.up_is_measured = true;
  EXPECT_FALSE(isFloorTiltedBy(most + 0.01));
  EXPECT_TRUE(isFloorTiltedBy(most - 0.01));
}

TEST_F(Selection, TheCameraIsNeitherLowerNorHigherThanItCanBe)
{
  scene_.add(kFloor);
  parameters_.min_camera_height = 1.01;
  EXPECT_EQ(best(), 0.0);
  parameters_.min_camera_height = 0.99;
  EXPECT_NEAR(best(), 1.0, 1e-3);
  parameters_.min_camera_height = 0.05;
  parameters_.max_camera_height = 0.99;
  EXPECT_EQ(best(), 0.0);
  EXPECT_TRUE(at(1.0).too_low) << "it is looked at all the same";
  parameters_.max_camera_height = 1.01;
  EXPECT_NEAR(best(), 1.0, 1e-3);
}

TEST_F(Selection, BoundsGiveNoBonus)
{
  parameters_ = FloorSelectionParameters();
  scene_.add(kFloor);
  scene_.add(raised(kFloor, 0.4), isLeft);
  rate();
  const double floor = at(1.0).score;
  const double table = at(0.6).score;
  parameters_.min_camera_height = 0.59;
  parameters_.max_camera_height = 1.01;
  rate();
  EXPECT_EQ(at(1.0).score, floor);
  EXPECT_EQ(at(0.6).score, table);
  parameters_.max_camera_height = 100.0;
  rate();
  EXPECT_EQ(at(1.0).score, floor);
  EXPECT_EQ(at(0.6).score, table);
}

// --- Each term of the score alone.

TEST_F(Selection, SupportIsTheLogarithmOfTheSamples)
{
  scene_.add(kFloor);
  scene_.add(raised(kFloor, 0.4), [](const Eigen::Vector3d& p) { return p.x() < -0.1; });
  rate();
  for (const FloorCandidate& candidate : selection_.candidates()) {
    EXPECT_GT(candidate.size, 100U);
    EXPECT_NEAR(candidate.score, std::log(static_cast<double>(candidate.size)), 1e-9);
  }
  ASSERT_GT(at(1.0).size, at(0.6).size);
  EXPECT_NEAR(bestOfRated(), 1.0, 0.01) << "the larger one";
}

TEST_F(Selection, TheLargerPlaneWinsWhereNothingElseIsKnown)
{
  scene_.add(kFloor);
  scene_.add(raised(kFloor, 0.4), [](const Eigen::Vector3d& p) { return p.x() < 0.1; });
  rate();
  ASSERT_GT(at(0.6).size, at(1.0).size);
  EXPECT_NEAR(bestOfRated(), 0.6, 0.01);
}

TEST_F(Selection, ATiltCosts)
{
  parameters_.tilt_about_seed = 0.32;
  parameters_.tilt_about_measured = 0.12;
  scene_.add(kFloor);
  prior_.up = Eigen::AngleAxisd(0.24, Eigen::Vector3d::UnitX()) * kFloor.normal;
  rate();
  EXPECT_NEAR(at(1.0).tilt, 0.24, 1e-3);
  EXPECT_NEAR(termOf(1.0), -0.5 * 0.75 * 0.75, 0.01) << "three quarters of a seed's standard deviation";
  prior_.up_is_measured = true;
  rate();
  EXPECT_NEAR(termOf(1.0), -0.5 * 2.0 * 2.0, 0.02) << "two standard deviations of a measured up";
}

TEST_F(Selection, ScatterBelowSpeaksAgainst)
{
  parameters_.scatter = 2.0;
  scene_.add(kFloor);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> deeper(1.3F, 2.5F);
  for (std::size_t v = 0; v < 120; ++v) {
    for (std::size_t u = 0; u < 60; ++u) scene_.depth()[160 * v + u] *= deeper(random);
  }
  rate();
  const FloorCandidate& floor = at(1.0);
  EXPECT_NEAR(floor.scatter, 12 * 32, 30) << "12 columns of samples are scattered";
  EXPECT_NEAR(termOf(1.0), -2.0 * std::log(1.0 + floor.scatter / (0.25 * floor.size)), 1e-9);
}

TEST_F(Selection, ScatterAboveOrTooDeepSaysNothing)
{
  std::mt19937 random(1);
  parameters_.scatter = 2.0;
  for (const auto& [least, most] : {std::pair{0.2F, 0.9F}, std::pair{3.5F, 7.0F}}) {
    scene_ = PlaneScene();
    scene_.add(kFloor);
    std::uniform_real_distribution<float> factor(least, most);
    for (std::size_t v = 0; v < 120; ++v) {
      for (std::size_t u = 0; u < 60; ++u) scene_.depth()[160 * v + u] *= factor(random);
    }
    rate();
    EXPECT_EQ(at(1.0).scatter, 0.0) << "samples at " << least << " to " << most << " m below the camera";
  }
}

TEST_F(Selection, APlaneBelowIsNoScatter)
{
  scene_.add(kFloor);
  scene_.add(raised(kFloor, 0.4), isLeft);
  rate();
  EXPECT_LT(at(0.6).scatter, 20.0) << "some samples at its edge may be of no plane; " << at(1.0).size
                                   << " are of the floor";
}

TEST_F(Selection, APlaneThatBeginsFarAwayCosts)
{
  parameters_.distance = 1.0;
  scene_.add(kFloor, [](const Eigen::Vector3d& p) { return ahead(p) > 1.5; });
  rate();
  const FloorCandidate& floor = at(1.0);
  EXPECT_GT(floor.begin, 1.5);
  EXPECT_LT(floor.begin, 1.8) << "a tenth of its samples may be nearer";
  EXPECT_GT(floor.middle, floor.begin);
  EXPECT_NEAR(termOf(1.0), -std::log(floor.begin), 1e-9);
}

TEST_F(Selection, NearerThanTenCentimetresIsAsGoodAsAtTheFeet)
{
  parameters_.distance = 1.0;
  const geometry::Plane below = floorSeenFrom(1.0, 90 * kDegree);  // straight down
  prior_.up = below.normal;
  scene_.add(below, [](const Eigen::Vector3d& p) { return p.head<2>().norm() < 0.2; });
  rate();
  ASSERT_LT(at(1.0).begin, 0.1);
  EXPECT_NEAR(termOf(1.0), -std::log(0.1), 1e-9);
}

// --- What the last frames say.

TEST_F(Selection, WhereTheLastFloorWasItIsAgain)
{
  parameters_.confirmed = 10.0;
  scene_.add(kFloor);
  prior_.height_tolerance = 0.06;
  prior_.height = 1.07;
  rate();
  EXPECT_FALSE(at(1.0).continues) << "7 cm lower";
  EXPECT_NEAR(termOf(1.0), 0.0, 1e-9);
  prior_.height = 1.05;
  rate();
  EXPECT_TRUE(at(1.0).continues) << "5 cm lower";
  EXPECT_NEAR(termOf(1.0), 0.0, 1e-9) << "a frame may be wrong";
  prior_.confirmed = true;
  rate();
  EXPECT_NEAR(termOf(1.0), 10.0, 1e-9);
}

TEST_F(Selection, NoCameraTurnsFarBetweenFrames)
{
  scene_.add(kFloor);
  prior_.height = 1.0;
  prior_.height_tolerance = 0.06;
  prior_.up = Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitX()) * kFloor.normal;
  rate();
  EXPECT_TRUE(at(1.0).continues) << "a seed is only rough";
  prior_.last = geometry::Plane{prior_.up, 1.0};
  rate();
  EXPECT_FALSE(at(1.0).continues) << "0.2 rad off what was measured";
  EXPECT_NEAR(termOf(1.0), 0.0, 1e-9);
}

TEST_F(Selection, APlaneThatWasSeenBesideTheLastFloorIsNone)
{
  parameters_.other_plane = 8.0;
  scene_.add(kFloor);
  prior_.height = 0.7;  // this is a storey 0.3 m lower
  prior_.height_tolerance = 0.06;
  prior_.others.add(-0.6);
  rate();
  EXPECT_FALSE(at(1.0).is_other_plane) << "that was a deeper one";
  EXPECT_NEAR(termOf(1.0), 0.0, 1e-9);
  prior_.others.add(-0.3);
  rate();
  EXPECT_TRUE(at(1.0).is_other_plane);
  EXPECT_NEAR(termOf(1.0), -8.0, 1e-9);
}

TEST_F(Selection, TheLastFloorItselfIsNoOtherPlane)
{
  parameters_.other_plane = 8.0;
  scene_.add(kFloor);
  prior_.height = 1.0;
  prior_.height_tolerance = 0.06;
  prior_.others.add(0.1);  // within same_offset + height_tolerance
  rate();
  EXPECT_TRUE(at(1.0).continues);
  EXPECT_FALSE(at(1.0).is_other_plane);
}

TEST_F(Selection, APlaneNearerThanAConfirmedFloorIsRaised)
{
  parameters_.other_plane = 8.0;
  scene_.add(kFloor);
  prior_.height = 1.3;
  prior_.height_tolerance = 0.06;
  rate();
  EXPECT_FALSE(at(1.0).is_other_plane) << "the last floor may have been none";
  prior_.confirmed = true;
  rate();
  EXPECT_TRUE(at(1.0).is_other_plane);
  EXPECT_NEAR(termOf(1.0), -8.0, 1e-9);
  prior_.height = 1.2;
  rate();
  EXPECT_FALSE(at(1.0).is_other_plane) << "so far a camera may sink";
}

TEST_F(Selection, AConfirmedFloorOutweighsALargerPlane)
{
  scene_.add(kFloor);
  scene_.add(raised(kFloor, 0.4), [](const Eigen::Vector3d& p) { return p.x() < 0.15; });
  parameters_.confirmed = 10.0;
  prior_.height = 1.0;
  prior_.height_tolerance = 0.06;
  prior_.confirmed = true;
  EXPECT_NEAR(best(), 1.0, 0.01);
  prior_.height = 0.6;
  EXPECT_NEAR(best(), 0.6, 0.01);
}

// --- What has too little in its favour, and what does not matter.

TEST_F(Selection, APlaneWithTooLittleInItsFavourIsNone)
{
  scene_.add(kFloor);
  rate();
  const double score = at(1.0).score;
  parameters_.least_score = score - 0.01;
  EXPECT_NEAR(best(), 1.0, 1e-3);
  parameters_.least_score = score + 0.01;
  EXPECT_EQ(best(), 0.0);
}

TEST_F(Selection, NothingOfTheLastFrameIsLeft)
{
  scene_.add(kFloor);
  scene_.add(raised(kFloor, 0.4), isLeft);
  rate();
  selection_.best(parameters_)->refused = true;
  rate();
  ASSERT_EQ(selection_.candidates().size(), 2U);
  for (const FloorCandidate& candidate : selection_.candidates()) EXPECT_FALSE(candidate.refused);
  scene_ = PlaneScene();
  scene_.add(raised(kFloor, 0.1), isRight);
  EXPECT_NEAR(best(), 0.9, 0.01);
  EXPECT_EQ(selection_.candidates().size(), 1U);
}

}  // namespace
}  // namespace polygonal_perception::test

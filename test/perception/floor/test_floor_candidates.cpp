#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "perception/floor/floor_candidates.hpp"
#include "support/plane_scene.hpp"

namespace polygonal_perception::perception {
namespace {

const geometry::Plane kFloor = test::floorSeenFrom(1.0, 0.7);

/// How far ahead of the camera a point lies, along the floor.
double ahead(const Eigen::Vector3d& point)
{
  return (point - kFloor.normal.dot(point) * kFloor.normal).norm();
}

bool isLeft(const Eigen::Vector3d& point)
{
  return point.x() < 0.0;
}

class Candidates : public testing::Test
{
protected:
  void collect()
  {
    grid_.update(scene_.view());
    candidates_.collect(grid_, parameters_, prior_);
  }

  /// The distance of the most likely floor; 0: there is none.
  double best()
  {
    collect();
    const FloorCandidate* candidate = candidates_.best(prior_);
    return candidate == nullptr ? 0.0 : candidate->plane.distance;
  }

  Candidates() { prior_.up = kFloor.normal; }

  test::PlaneScene scene_;
  SampleGrid grid_{SampleGrid::Parameters{}};
  FloorDetector::Parameters parameters_;
  FloorPrior prior_;
  FloorCandidates candidates_;
};

TEST_F(Candidates, ABareFloorIsOne)
{
  scene_.add(kFloor);
  EXPECT_NEAR(best(), 1.0, 1e-3);
  const FloorCandidate* floor = candidates_.best(prior_);
  ASSERT_NE(floor, nullptr);
  EXPECT_LT(angleBetween(floor->plane.normal, kFloor.normal), 1e-3);
  EXPECT_EQ(floor->counts.inliers, 32 * 32);
  EXPECT_EQ(floor->counts.below, 0);
  EXPECT_TRUE(floor->lowest);
  EXPECT_FALSE(floor->continues) << "nothing was known";
}

TEST_F(Candidates, AWallIsNone)
{
  scene_.add({-Eigen::Vector3d::UnitX(), 0.3});
  collect();
  EXPECT_TRUE(candidates_.empty());
  EXPECT_EQ(candidates_.best(prior_), nullptr);
}

TEST_F(Candidates, AFrameWithoutReturnsHasNone)
{
  collect();
  EXPECT_TRUE(candidates_.empty());
}

TEST_F(Candidates, ATableIsNotTheFloorUnderIt)
{
  scene_.add(kFloor);
  scene_.add(test::raised(kFloor, 0.5), isLeft);
  EXPECT_NEAR(best(), 1.0, 0.01);
  const PlaneOffsets others = candidates_.others(kFloor);
  ASSERT_EQ(others.end() - others.begin(), 1);
  EXPECT_NEAR(*others.begin(), 0.5, 0.01) << "the table, above the floor";
}

TEST_F(Candidates, APlaneIsGivenUpForTheNext)
{
  scene_.add(kFloor);
  scene_.add(test::raised(kFloor, 0.5), isLeft);
  collect();
  FloorCandidate* floor = candidates_.best(prior_);
  ASSERT_NE(floor, nullptr);
  floor->refused = true;
  EXPECT_EQ(candidates_.best(prior_), nullptr) << "the table has the floor below it";
}

TEST_F(Candidates, TheCameraIsNeitherLowerNorHigherThanItCanBe)
{
  scene_.add(kFloor);
  parameters_.min_camera_height = 1.02;
  EXPECT_EQ(best(), 0.0);
  parameters_.min_camera_height = 0.05;
  parameters_.max_camera_height = 0.98;
  EXPECT_EQ(best(), 0.0);
  parameters_.max_camera_height = 1.02;
  EXPECT_NEAR(best(), 1.0, 1e-3);
}

TEST_F(Candidates, AMeasuredUpAllowsLessTiltThanASeed)
{
  scene_.add(kFloor);
  const double tilt = parameters_.max_tilt + 0.1;
  prior_.up = Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitX()) * kFloor.normal;
  EXPECT_NEAR(best(), 1.0, 1e-3);
  prior_.up_is_measured = true;
  EXPECT_EQ(best(), 0.0);
  prior_.up = Eigen::AngleAxisd(tilt - 0.2, Eigen::Vector3d::UnitX()) * kFloor.normal;
  EXPECT_NEAR(best(), 1.0, 1e-3);
}

TEST_F(Candidates, AHandfulOfSamplesIsNone)
{
  scene_.add(kFloor, [](const Eigen::Vector3d& p) { return p.head<2>().norm() < 0.045; });
  EXPECT_EQ(best(), 0.0);
}

TEST_F(Candidates, APlaneWhereTheLastFloorWasContinuesIt)
{
  scene_.add(kFloor);
  prior_.height_tolerance = 0.06;
  const auto continues = [this](double height) {
    prior_.height = height;
    collect();
    const FloorCandidate* floor = candidates_.best(prior_);
    return floor != nullptr && floor->continues;
  };
  EXPECT_TRUE(continues(1.05));
  EXPECT_FALSE(continues(1.07));
  prior_.up_is_measured = true;
  EXPECT_TRUE(continues(1.05));
  prior_.up = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()) * kFloor.normal;
  EXPECT_FALSE(continues(1.05)) << "no camera turns that far between frames";
}

TEST_F(Candidates, APlaneThatWasSeenBesideTheLastFloorIsNone)
{
  // A storey 0.3 m lower.
  scene_.add(kFloor);
  prior_.height = 0.7;
  prior_.height_tolerance = 0.06;
  EXPECT_NEAR(best(), 1.0, 1e-3);
  prior_.others.add(-0.6);
  EXPECT_NEAR(best(), 1.0, 1e-3) << "another one";
  prior_.others.add(-0.3);
  EXPECT_EQ(best(), 0.0);
}

TEST_F(Candidates, APlaneNearerThanAConfirmedFloorIsRaised)
{
  scene_.add(kFloor);
  prior_.height = 1.3;
  EXPECT_NEAR(best(), 1.0, 1e-3) << "the last floor may have been none";
  prior_.confirmed = true;
  EXPECT_EQ(best(), 0.0);
  prior_.height = 1.2;
  EXPECT_NEAR(best(), 1.0, 1e-3) << "so far a camera may sink";
}

TEST_F(Candidates, TheLandingAboveStairsIsTheFloor)
{
  // Treads of 17 cm, of which the second is too low for a floor.
  const geometry::Plane landing = test::raised(kFloor, 0.2);
  scene_.add(landing, [](const Eigen::Vector3d& p) { return ahead(p) < 0.9; });
  scene_.add(test::raised(landing, -0.17),
             [](const Eigen::Vector3d& p) { return ahead(p) > 0.9 && ahead(p) < 1.7; });
  scene_.add(test::raised(landing, -0.34),
             [](const Eigen::Vector3d& p) { return ahead(p) > 1.7 && ahead(p) < 2.9; });
  EXPECT_NEAR(best(), 1.14, 0.05) << "where the camera may be that high, the lowest";
  parameters_.max_camera_height = 1.05;
  EXPECT_NEAR(best(), 0.8, 0.01);
  EXPECT_TRUE(candidates_.best(prior_)->is_stair_top);
}

TEST_F(Candidates, EachSampleIsLabelled)
{
  scene_.add(kFloor, [](const Eigen::Vector3d& p) { return ahead(p) < 1.8; });
  scene_.add(test::raised(kFloor, 0.4), [](const Eigen::Vector3d& p) { return isLeft(p) && ahead(p) < 0.8; });
  scene_.add({Eigen::Vector3d(-1.0, 0.0, 0.0), 0.4});  // a wall to the right
  collect();
  std::vector<SampleLabel> labels;
  const std::uint32_t on_floor = candidates_.label(kFloor, parameters_, labels);
  ASSERT_EQ(labels.size(), grid_.samples().size());
  const auto number = [&labels](SampleLabel label) {
    return static_cast<std::uint32_t>(std::count(labels.begin(), labels.end(), label));
  };
  EXPECT_EQ(number(SampleLabel::kFloor), on_floor);
  for (const SampleLabel label :
       {SampleLabel::kFloor, SampleLabel::kSegment, SampleLabel::kPruned, SampleLabel::kNoPoint}) {
    EXPECT_GT(number(label), 50U) << "label " << static_cast<int>(label);
  }
  for (std::size_t k = 0; k < labels.size(); ++k) {
    const Sample& sample = grid_.samples()[k];
    EXPECT_EQ(labels[k] == SampleLabel::kNoPoint, !sample.has_point) << "sample " << k;
    const double height = kFloor.height(sample.point.cast<double>());
    if (labels[k] == SampleLabel::kFloor) {
      EXPECT_NEAR(height, 0.0, 0.05) << "sample " << k;
    } else if (labels[k] == SampleLabel::kSegment) {
      EXPECT_NEAR(height, 0.4, 0.05) << "sample " << k;
    }
  }
}

TEST_F(Candidates, WithoutAFloorNoSampleIsOnIt)
{
  scene_.add(kFloor);
  collect();
  std::vector<SampleLabel> labels;
  EXPECT_EQ(candidates_.label(std::nullopt, parameters_, labels), 0U);
  EXPECT_EQ(std::count(labels.begin(), labels.end(), SampleLabel::kSegment), 32 * 32);
}

TEST(FloorCandidate, IsAtCameraHeightWithinBothBounds)
{
  FloorDetector::Parameters parameters;
  parameters.min_camera_height = 0.5;
  parameters.max_camera_height = 1.5;
  for (const auto& [distance, expected] : {std::pair{0.49, false}, {0.5, true}, {1.5, true}, {1.51, false}})
    EXPECT_EQ(isAtCameraHeight({Eigen::Vector3d::UnitZ(), distance}, parameters), expected) << distance;
}

TEST(FloorCandidate, IsLowestWithHardlyASampleBelow)
{
  FloorDetector::Parameters parameters;
  parameters.replacement_factor = 20.0;
  parameters.max_camera_height = 3.0;
  const geometry::Plane plane{Eigen::Vector3d::UnitZ(), 1.0};
  EXPECT_TRUE(isLowest(plane, {100, 5}, parameters));
  EXPECT_FALSE(isLowest(plane, {100, 6}, parameters));
  const geometry::Plane deep{Eigen::Vector3d::UnitZ(), 2.71};
  EXPECT_TRUE(isLowest(deep, {100, 100}, parameters)) << "no floor could be below";
}

}  // namespace
}  // namespace polygonal_perception::perception

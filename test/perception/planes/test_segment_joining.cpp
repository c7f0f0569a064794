#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "perception/planes/segment_joining.hpp"
#include "polygonal_perception/geometry/angle.hpp"
#include "support/plane_scene.hpp"

namespace polygonal_perception::perception {
namespace {

constexpr double kDegree = 0.017453292519943295;

const geometry::Plane kFloor{Eigen::Vector3d::UnitZ(), 1.0};

/// A square piece of a plane, 11 x 11 samples about the point of it that is over (x, y).
/// @param error  [m] the samples lie so far above and below it, in turns
PlaneSegment piece(const geometry::Plane& plane, double x, double y, double side = 0.5, double error = 0.002)
{
  PlaneSegment segment;
  for (int i = 0; i <= 10; ++i) {
    for (int j = 0; j <= 10; ++j) {
      const Eigen::Vector3d over(x + side * (0.1 * i - 0.5), y + side * (0.1 * j - 0.5), 0.0);
      Eigen::Vector3d p = over - plane.height(over) / plane.normal.z() * Eigen::Vector3d::UnitZ();
      p += ((i + j) % 2 == 0 ? error : -error) * plane.normal;
      segment.points.add(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()),
                         1.0F);
    }
  }
  segment.fit = *segment.points.solve(plane.normal);
  return segment;
}

/// The plane turned about the line over (x, any y): so steeply does it rise from there.
geometry::Plane turned(const geometry::Plane& plane, double angle, double x)
{
  const Eigen::Vector3d normal = Eigen::AngleAxisd(-angle, Eigen::Vector3d::UnitY()) * plane.normal;
  return {normal, -normal.dot(Eigen::Vector3d(x, 0.0, -plane.distance))};
}

/// One sample names each of the segments.
PlaneSegments afterJoining(std::vector<PlaneSegment> pieces, const PlaneExtractionParameters& parameters = {})
{
  PlaneSegments segments;
  for (std::size_t k = 0; k < pieces.size(); ++k) segments.of_sample.push_back(static_cast<int>(k));
  segments.of_sample.push_back(PlaneSegments::kNone);
  segments.all = std::move(pieces);
  SegmentContacts contacts;  // no piece touches another
  SegmentJoining().join(parameters, contacts, segments);
  return segments;
}

TEST(SegmentJoining, AFloorOnBothSidesOfALegIsOne)
{
  const PlaneSegments joined = afterJoining({piece(kFloor, -0.3, 1.5), piece(kFloor, 0.3, 1.5)});
  ASSERT_EQ(joined.all.size(), 1U);
  EXPECT_EQ(joined.all[0].points.count(), 242U) << "the samples of both";
  EXPECT_EQ(joined.of_sample, (std::vector<int>{0, 0, PlaneSegments::kNone}));
  EXPECT_NEAR(joined.all[0].fit.centre.x(), 0.0, 1e-5) << "it is fitted to both";
  EXPECT_NEAR(joined.all[0].fit.plane.distance, 1.0, 1e-4);
}

TEST(SegmentJoining, APieceMetresAwayIsStillOfThePlane)
{
  EXPECT_EQ(afterJoining({piece(kFloor, 0.0, 0.8), piece(kFloor, 0.0, 3.8)}).all.size(), 1U);
}

TEST(SegmentJoining, AStepOf3CentimetresStaysTwo)
{
  for (const double step : {0.03, 0.05, 0.1}) {
    const auto joined = afterJoining({piece(kFloor, -0.3, 1.5), piece(test::raised(kFloor, step), 0.3, 1.5)});
    EXPECT_EQ(joined.all.size(), 2U) << "step " << step;
    EXPECT_EQ(joined.of_sample, (std::vector<int>{0, 1, PlaneSegments::kNone})) << "step " << step;
  }
}

TEST(SegmentJoining, AStepOf4MillimetresIsWhatALensBends)
{
  EXPECT_EQ(afterJoining({piece(kFloor, -0.3, 1.5), piece(test::raised(kFloor, 0.004), 0.3, 1.5)}).all.size(),
            1U);
}

/// Two pieces that touch, in the middle between them.
std::size_t countAfterTouching(const PlaneSegment& a, const PlaneSegment& b)
{
  PlaneSegments segments;
  segments.all = {a, b};
  segments.of_sample = {0, 1};
  NoisySamples samples;
  samples.columns = 2;
  samples.all.resize(2);
  samples.all[0].point = samples.all[1].point = (0.5 * (a.fit.centre + b.fit.centre)).cast<float>();
  samples.all[1].ends_row = true;
  SegmentContacts contacts;
  contacts.find(samples, segments);
  SegmentJoining().join({}, contacts, segments);
  return segments.all.size();
}

TEST(SegmentJoining, PiecesThatALensBendsAreOneWhereTheyTouch)
{
  // A real floor, 1 m away: two degrees to either side. At the middle of one the other is 8 mm off.
  const geometry::Plane bent = turned(kFloor, 1.0 * kDegree, 0.25);
  const PlaneSegment a = piece(kFloor, 0.0, 1.0, 0.5, 0.0005);
  const PlaneSegment b = piece(bent, 0.73, 1.0, 0.5, 0.0005);
  EXPECT_EQ(afterJoining({a, b}).all.size(), 2U) << "if they did not touch";
  EXPECT_EQ(countAfterTouching(a, b), 1U);
}

TEST(SegmentJoining, PiecesThatTouchAStepApartStayTwo)
{
  const PlaneSegment a = piece(kFloor, 0.0, 1.0, 0.5, 0.0005);
  const PlaneSegment b = piece({kFloor.normal, kFloor.distance - 0.012}, 0.5, 1.0, 0.5, 0.0005);
  EXPECT_EQ(countAfterTouching(a, b), 2U) << "12 mm";
}

TEST(SegmentJoining, AnAngleOf8DegreesStaysTwo)
{
  // The pieces meet where the ramp begins, so that the offset alone would hardly tell.
  EXPECT_EQ(
      afterJoining({piece(kFloor, -0.1, 1.5, 0.2), piece(turned(kFloor, 8 * kDegree, 0.1), 0.1, 1.5, 0.2)})
          .all.size(),
      2U);
}

TEST(SegmentJoining, TheAngleAloneTellsWherePlanesCross)
{
  // The middle of each piece lies on the line where the two planes cross.
  EXPECT_EQ(
      afterJoining({piece(kFloor, 0.0, 1.0), piece(turned(kFloor, 8 * kDegree, 0.0), 0.0, 2.0)}).all.size(),
      2U);
  EXPECT_EQ(
      afterJoining({piece(kFloor, 0.0, 1.0), piece(turned(kFloor, 1 * kDegree, 0.0), 0.0, 2.0)}).all.size(),
      1U);
}

TEST(SegmentJoining, TheOffsetMustFitBothWays)
{
  // The middle of the ramp's piece is where the ramp leaves the floor; the floor's piece lies 1 m before it,
  // where the ramp's plane is 2.6 cm deeper. Angles so small do not tell.
  EXPECT_EQ(
      afterJoining({piece(kFloor, 0.0, 1.0), piece(turned(kFloor, 1.5 * kDegree, 1.0), 1.0, 1.0)}).all.size(),
      2U);
}

TEST(SegmentJoining, WhatStaysIsNumberedAnew)
{
  // The larger pieces stay, and they come last, in another order.
  const auto twice = [](PlaneSegment segment) {
    segment.points.add(PlaneFit(segment.points));
    return segment;
  };
  const auto joined =
      afterJoining({piece(kFloor, -0.6, 1.5), piece(test::raised(kFloor, 0.2), -0.6, 1.5),
                    twice(piece(test::raised(kFloor, 0.2), 0.6, 1.5)), twice(piece(kFloor, 0.6, 1.5))});
  ASSERT_EQ(joined.all.size(), 2U);
  const std::vector<double> expected = {1.0, 0.8, 0.8, 1.0};
  for (std::size_t k = 0; k < 4; ++k) {
    ASSERT_GE(joined.of_sample[k], 0) << "sample " << k;
    ASSERT_LT(joined.of_sample[k], 2) << "sample " << k;
    EXPECT_NEAR(joined.all[static_cast<std::size_t>(joined.of_sample[k])].fit.plane.distance, expected[k],
                1e-4)
        << "sample " << k;
  }
}

TEST(SegmentJoining, ParallelPlanesThatFaceEachOtherStayTwo)
{
  // Both sides of a thin shelf have one place, and opposite normals.
  PlaneSegment under = piece(kFloor, 0.3, 1.5);
  under.fit.plane.normal = -under.fit.plane.normal;
  under.fit.plane.distance = -under.fit.plane.distance;
  EXPECT_EQ(afterJoining({piece(kFloor, -0.3, 1.5), under}).all.size(), 2U);
}

TEST(SegmentJoining, AnUncertainPieceJoinsWhatACertainOneDoesNot)
{
  // A piece of 10 cm whose samples err by 1 cm may be turned by 8 degrees; one whose samples err by 1 mm is
  // not.
  const geometry::Plane other = turned(kFloor, 5 * kDegree, 0.3);
  EXPECT_EQ(afterJoining({piece(kFloor, -0.3, 1.5), piece(other, 0.3, 1.5, 0.1, 0.01)}).all.size(), 1U);
  EXPECT_EQ(afterJoining({piece(kFloor, -0.3, 1.5), piece(other, 0.3, 1.5, 0.1, 0.001)}).all.size(), 2U);
}

TEST(SegmentJoining, ThreePlanesOfTwoPiecesEachAreThree)
{
  std::vector<PlaneSegment> pieces;
  for (const double x : {-0.6, 0.6}) {
    for (const double up : {0.0, 0.2, 0.4}) pieces.push_back(piece(test::raised(kFloor, up), x, 1.5));
  }
  const auto joined = afterJoining(pieces);
  ASSERT_EQ(joined.all.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    ASSERT_EQ(joined.of_sample[k], joined.of_sample[k + 3]) << "both pieces of plane " << k;
    EXPECT_NEAR(joined.all[static_cast<std::size_t>(joined.of_sample[k])].fit.plane.distance,
                1.0 - 0.2 * static_cast<double>(k), 1e-4)
        << "sample " << k << " names the segment that it is in";
  }
}

TEST(SegmentJoining, TheOrderOfThePiecesDoesNotMatter)
{
  const std::vector<PlaneSegment> pieces = {
      piece(kFloor, -0.3, 1.5), piece(test::raised(kFloor, 0.1), 0.3, 1.5), piece(kFloor, 0.9, 1.5, 0.2)};
  std::vector<int> order = {0, 1, 2};
  do {
    std::vector<PlaneSegment> shuffled;
    for (const int k : order) shuffled.push_back(pieces[static_cast<std::size_t>(k)]);
    const auto joined = afterJoining(shuffled);
    ASSERT_EQ(joined.all.size(), 2U);
    std::size_t samples = 0;
    for (const PlaneSegment& segment : joined.all) samples += segment.points.count();
    EXPECT_EQ(samples, 363U) << "no sample is lost, and none counts twice";
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(SegmentJoining, OfNoneThereIsNone)
{
  EXPECT_TRUE(afterJoining({}).all.empty());
}

}  // namespace
}  // namespace polygonal_perception::perception

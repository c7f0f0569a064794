#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "extracted_scene.hpp"
#include "polygonal_perception/perception/segmentation/plane_segmentation.hpp"

namespace polygonal_perception::perception {
namespace {

using test::around;
using test::ExtractedScene;
using test::wallAt;

constexpr double kDegree = 0.017453292519943295;

const geometry::Plane kFloor = test::floorSeenFrom(0.5, 1.2);
const Eigen::Vector3d kAhead(0.0, kFloor.normal.z(), -kFloor.normal.y());  // along the floor

/// A wall 1 m away with something in a rectangle of the image.
test::PlaneScene wallWith(const test::Pixels& pixels, float depth)
{
  test::PlaneScene scene;
  scene.add(wallAt(1.0));
  paint(scene, pixels, depth);
  return scene;
}

/// The whole height of the image round some columns of samples.
test::Pixels columns(int first, int last)
{
  return {test::columnOf(first) - 2, test::columnOf(last) + 2, 0, 119};
}

test::Pixels rows(int first, int last)
{
  return {0, 159, test::rowOf(first) - 1, test::rowOf(last) + 1};
}

/// Samples in the pieces, the largest first.
std::vector<std::uint32_t> countsOf(const PlanePieces& pieces)
{
  std::vector<std::uint32_t> counts;
  for (const PlanePieces::Piece& piece : pieces.pieces()) counts.push_back(piece.sample_count);
  std::sort(counts.rbegin(), counts.rend());
  return counts;
}

using Counts = std::vector<std::uint32_t>;

TEST(PlanePieces, AWallIsOnePieceOfAllSamples)
{
  test::PlaneScene scene;
  scene.add(wallAt(1.0));
  const ExtractedScene seen(scene);
  ASSERT_EQ(countsOf(seen.pieces), Counts{1024});
  const PlanePieces::Piece& piece = seen.pieces.pieces()[0];
  EXPECT_EQ(piece.size, 1024U) << "there is nothing to bridge";
  const auto& cells = seen.pieces.cells();
  EXPECT_EQ(std::set<std::uint32_t>(cells.begin(), cells.end()).size(), 1024U) << "each sample once";
}

TEST(PlanePieces, SamplesInTheCornerOfARoomAreOfTheWallThatTheyLieOn)
{
  // Across the corner the normal of a sample is that of neither wall.
  test::PlaneScene scene;
  const Eigen::Vector3d corner(1.5 * (test::columnOf(16) - 79.5) / test::kFocalLength, 0.0, 1.5);
  for (const double side : {-1.0, 1.0}) {
    const Eigen::Vector3d normal = Eigen::Vector3d(side, 0.0, -1.0).normalized();
    scene.add({normal, -normal.dot(corner)});
  }
  const ExtractedScene seen(scene);
  ASSERT_EQ(seen.extraction.planes().size(), 2U);
  const auto without = [](const std::vector<int>& plane_of) {
    return std::count(plane_of.begin(), plane_of.end(), PlaneSegments::kNone);
  };
  EXPECT_GE(without(seen.extraction.planeOf()), 32) << "a column of samples is left over";
  EXPECT_EQ(without(seen.pieces.planeOf()), 0);
  for (std::size_t k = 0; k < seen.pieces.planeOf().size(); ++k) {
    const int plane = seen.pieces.planeOf()[k];
    if (plane == PlaneSegments::kNone) continue;
    const geometry::Plane& found = seen.extraction.planes()[static_cast<std::size_t>(plane)].fit.plane;
    EXPECT_NEAR(found.height(seen.grid.samples()[k].point.cast<double>()), 0.0, 0.015) << "sample " << k;
  }
}

TEST(PlanePieces, AllSamplesOfABoardBeforeAWallAreOfIt)
{
  // Of the outermost ones the normals are wrong: the board's edges, and its corners, too, lie on it none the less.
  for (const float wall : {2.0F, 1.1F, 1.05F}) {
    test::PlaneScene scene;
    scene.add(wallAt(wall));
    paint(scene, around(10, 20, 10, 20), 1.0F);
    const ExtractedScene seen(scene);
    EXPECT_EQ(countsOf(seen.pieces), (Counts{1024 - 121, 121})) << "a wall at " << wall << " m";
  }
}

TEST(PlanePieces, ASampleBesideAPlaneButNotOnItIsNotOfIt)
{
  // One sample 10 cm behind the wall: its normal is none of the wall's, and it is far from it.
  const ExtractedScene seen(wallWith(around(16, 16, 16, 16), 1.1F));
  EXPECT_EQ(seen.pieces.planeOf()[seen.sampleAt(16, 16)], PlaneSegments::kNone);
  EXPECT_EQ(countsOf(seen.pieces), Counts{1023});
}

TEST(PlanePieces, ALegOneSampleWideDoesNotPartAWall)
{
  for (const test::Pixels& leg : {columns(16, 16), rows(16, 16)}) {
    const ExtractedScene seen(wallWith(leg, 0.5F));
    const char* const how = leg.top == 0 ? "an upright leg" : "a level one";
    ASSERT_EQ(countsOf(seen.pieces), Counts{992}) << how;
    EXPECT_EQ(seen.pieces.pieces()[0].size, 1024U) << how << ": its samples are bridged, but not counted";
  }
}

TEST(PlanePieces, WhereNothingReturnsOneSampleWideAWallIsNotPartedEither)
{
  const ExtractedScene seen(wallWith(columns(16, 16), test::kNoReturn));
  EXPECT_EQ(countsOf(seen.pieces), Counts{992});
}

TEST(PlanePieces, AGapThroughWhichOneSeesFartherPartsAWall)
{
  for (const test::Pixels& gap : {columns(16, 16), rows(16, 16)}) {
    const ExtractedScene seen(wallWith(gap, 3.0F));
    const char* const how = gap.top == 0 ? "an upright gap" : "a level one";
    ASSERT_EQ(countsOf(seen.pieces), (Counts{512, 480})) << how;
    EXPECT_EQ(seen.pieces.pieces()[0].plane, seen.pieces.pieces()[1].plane) << how << ": one fit for both";
  }
}

TEST(PlanePieces, WhatHidesTwoSamplesPartsAWall)
{
  EXPECT_EQ(countsOf(ExtractedScene(wallWith(columns(16, 17), 0.5F)).pieces), (Counts{512, 448}));
  EXPECT_EQ(countsOf(ExtractedScene(wallWith(columns(16, 17), test::kNoReturn)).pieces), (Counts{512, 448}));
}

TEST(PlanePieces, ALegThatIsAPlaneItselfIsAPieceToo)
{
  // A board of 2 x 32 samples before the wall has 64 samples of its own plane.
  const ExtractedScene seen(wallWith(columns(16, 17), 0.8F));
  ASSERT_EQ(countsOf(seen.pieces), (Counts{512, 448, 64}));
  std::set<std::size_t> planes;
  for (const PlanePieces::Piece& piece : seen.pieces.pieces()) planes.insert(piece.plane);
  EXPECT_EQ(planes.size(), 2U) << "the wall's two pieces are of one";
}

TEST(PlanePieces, WhatTouchesInACornerOnlyIsTwo)
{
  test::PlaneScene scene;
  scene.add(wallAt(1.0));
  // Free are the lower left and the upper right quarter of the image.
  paint(scene, {0, test::columnOf(15) + 2, test::rowOf(16) - 1, 119}, 3.0F);
  paint(scene, {test::columnOf(15) + 3, 159, 0, test::rowOf(16) - 2}, 3.0F);
  const ExtractedScene seen(scene);
  std::vector<std::uint32_t> near;
  for (const PlanePieces::Piece& piece : seen.pieces.pieces()) {
    if (seen.grid.samples()[seen.pieces.cells()[piece.first]].point.z() < 2.0F)
      near.push_back(piece.sample_count);
  }
  EXPECT_EQ(near, (Counts{256, 256})) << "the quarters of the wall that are 1 m away";
}

TEST(PlanePieces, APieceOfFewerThanTheLeastSamplesIsLeftOut)
{
  // A wall of 20 x 32 samples, and beyond a gap of it 4 x 5 more.
  test::PlaneScene scene;
  scene.add(wallAt(1.0));
  paint(scene, {test::columnOf(20) - 2, 159, 0, 119}, 3.0F);
  paint(scene, around(25, 28, 10, 14), 1.0F);
  const auto near = [&](std::uint32_t least) {
    const ExtractedScene seen(scene, least);
    Counts counts;
    std::uint32_t cells = 0;
    for (const PlanePieces::Piece& piece : seen.pieces.pieces()) {
      cells += piece.size;
      if (seen.grid.samples()[seen.pieces.cells()[piece.first]].point.z() < 2.0F)
        counts.push_back(piece.sample_count);
    }
    EXPECT_EQ(seen.pieces.cells().size(), cells) << "cells of pieces only, least " << least;
    return counts;
  };
  EXPECT_EQ(near(20), (Counts{640, 20}));
  EXPECT_EQ(near(21), (Counts{640}));
  EXPECT_EQ(near(641), Counts{});
}

TEST(PlanePieces, BridgedSamplesDoNotMakeAPieceLarger)
{
  // A leg before the middle column of five: 32 samples are on the wall, and 8 are not.
  test::PlaneScene scene;
  paint(scene, around(10, 14, 10, 17), 1.0F);
  paint(scene, around(12, 12, 10, 17), 0.5F);
  EXPECT_EQ(countsOf(ExtractedScene(scene, 32).pieces), Counts{32});
  EXPECT_EQ(countsOf(ExtractedScene(scene, 33).pieces), Counts{});
}

/// A floor that rises by an angle from 0.2 m ahead: how many samples are on the wrong side of that line.
int onTheWrongSide(double angle, double normal_margin)
{
  constexpr double kFrom = 0.2;
  const Eigen::Vector3d up = std::cos(angle) * kFloor.normal - std::sin(angle) * kAhead;
  const Eigen::Vector3d foot = kFrom * kAhead - kFloor.distance * kFloor.normal;
  test::PlaneScene scene(160, 120, 142.5, 0.003);
  scene.add(kFloor, [](const Eigen::Vector3d& p) { return kAhead.dot(p) < kFrom; });
  scene.add({up, -up.dot(foot)}, [](const Eigen::Vector3d& p) { return kAhead.dot(p) >= kFrom; });
  const ExtractedScene seen(scene, 11, normal_margin);
  EXPECT_EQ(seen.extraction.planes().size(), 2U);
  int wrong = 0;
  for (std::size_t k = 0; k < seen.grid.samples().size(); ++k) {
    const int plane = seen.pieces.planeOf()[k];
    if (plane == PlaneSegments::kNone) continue;
    const Eigen::Vector3d& normal =
        seen.extraction.planes()[static_cast<std::size_t>(plane)].fit.plane.normal;
    const bool is_ramp = normal.dot(up) > normal.dot(kFloor.normal);
    // In the line itself, a sample's width to each side, either is right.
    const double beyond = kAhead.dot(seen.grid.samples()[k].point.cast<double>()) - kFrom;
    wrong += std::abs(beyond) > 0.03 && is_ramp != (beyond > 0.0) ? 1 : 0;
  }
  return wrong;
}

TEST(PlanePieces, WhereABoardRisesSamplesAreOfThatWhoseNormalTheyHave)
{
  for (const double degrees : {8.0, 10.0, 12.0}) {
    // No cosine is larger by 2: what has grown too far stays.
    const int grown = onTheWrongSide(degrees * kDegree, 2.0);
    EXPECT_LT(onTheWrongSide(degrees * kDegree, PlaneSegmentation::Parameters{}.normal_margin), grown)
        << degrees << " degrees: samples of the wrong plane";
  }
}

TEST(PlanePieces, LeavingOutOnePieceKeepsTheOthers)
{
  ExtractedScene seen(wallWith(columns(16, 16), 3.0F));
  ASSERT_EQ(countsOf(seen.pieces), (Counts{512, 480}));
  const std::vector<std::uint32_t> cells = seen.pieces.cells();
  seen.pieces.removeIf([](const PlanePieces::Piece& piece) { return piece.sample_count == 512; });
  ASSERT_EQ(countsOf(seen.pieces), Counts{480});
  EXPECT_EQ(seen.pieces.cells(), cells) << "a piece says where its cells are: they stay there";
}

TEST(PlanePieces, NothingOfTheLastFrameIsLeft)
{
  ExtractedScene seen(wallWith(columns(16, 16), 3.0F));
  ASSERT_EQ(seen.pieces.pieces().size(), 2U);
  const ExtractedScene empty{test::PlaneScene()};
  seen.pieces.find(empty.extraction, empty.parameters, 11, 0.01);
  EXPECT_TRUE(seen.pieces.pieces().empty());
  EXPECT_TRUE(seen.pieces.cells().empty());
  EXPECT_EQ(seen.pieces.planeOf(), std::vector<int>(1024, PlaneSegments::kNone));
}

}  // namespace
}  // namespace polygonal_perception::perception

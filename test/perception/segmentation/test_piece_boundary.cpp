#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "extracted_scene.hpp"
#include "perception/segmentation/piece_boundary.hpp"

namespace polygonal_perception::perception {
namespace {

using test::around;
using test::ExtractedScene;
using test::Pixels;
using test::wallAt;

using Ring = std::vector<Eigen::Vector3f>;

/// The boundary of the piece that a sample is in.
Ring boundaryAt(const ExtractedScene& seen, const PointView& points, int i, int j)
{
  Ring ring;
  const auto& cells = seen.pieces.cells();
  for (const PlanePieces::Piece& piece : seen.pieces.pieces()) {
    const auto first = cells.begin() + piece.first;
    if (std::find(first, first + piece.size, seen.sampleAt(i, j)) == first + piece.size) continue;
    PieceBoundary().trace(points, seen.grid, seen.lookup, cells.data(), piece,
                          seen.extraction.planes()[piece.plane].fit.plane, ring);
    return ring;
  }
  ADD_FAILURE() << "sample " << i << ", " << j << " is in no piece";
  return ring;
}

Ring boundaryAt(const test::PlaneScene& scene, int i, int j)
{
  return boundaryAt(ExtractedScene(scene), scene.view(), i, j);
}

/// Where a vertex is in the image [px].
Eigen::Vector2d pixelOf(const Eigen::Vector3f& vertex)
{
  return Eigen::Vector2d(79.5, 59.5) + test::kFocalLength * vertex.head<2>().cast<double>() / vertex.z();
}

/// [m^2] The area of a ring about a normal, negative where it is clockwise to somebody whom the normal points to.
double areaAbout(const Eigen::Vector3d& normal, const Ring& ring)
{
  double area = 0.0;
  for (std::size_t k = 0; k < ring.size(); ++k)
    area += 0.5 * normal.dot(ring[k].cast<double>().cross(ring[(k + 1) % ring.size()].cast<double>()));
  return area;
}

/// [m^2] Of pixels of a wall that is seen straight on; from middle to middle of the outermost ones.
double areaOf(const Pixels& pixels, double distance)
{
  const double pixel = distance / test::kFocalLength;
  return pixel * pixel * (pixels.right - pixels.left) * (pixels.bottom - pixels.top);
}

/// [px] How far a point of the image is from the edge of a rectangle.
double toEdge(const Eigen::Vector2d& at, const Pixels& pixels)
{
  const Eigen::Vector2d inwards(std::min(at.x() - pixels.left, pixels.right - at.x()),
                                std::min(at.y() - pixels.top, pixels.bottom - at.y()));
  return inwards.minCoeff() >= 0.0 ? inwards.minCoeff() : inwards.cwiseMin(0.0).norm();
}

double toPoint(const Ring& ring, const Eigen::Vector2d& point)
{
  double least = 1e9;
  for (const auto& vertex : ring) least = std::min(least, (pixelOf(vertex) - point).norm());
  return least;
}

void expectOnPlane(const Ring& ring, const geometry::Plane& plane)
{
  ASSERT_GE(ring.size(), 3U);
  for (const auto& vertex : ring)
    EXPECT_NEAR(plane.height(vertex.cast<double>()), 0.0, 1e-4) << "at " << vertex.transpose();
}

/// Rectangles of a wall that fall between the samples in many ways.
class Rectangle : public testing::TestWithParam<Pixels>
{
};

/// Sees a rectangle of a wall 1 m away before, or behind, something else.
/// @param tolerance  [px] of the vertices
void expectBoundary(const Pixels& pixels, float around, double tolerance)
{
  test::PlaneScene scene;
  paint(scene, {0, 159, 0, 119}, around);
  paint(scene, pixels, 1.0F);
  const Ring ring = boundaryAt(scene, 14, 14);
  expectOnPlane(ring, wallAt(1.0));
  for (const auto& vertex : ring) {
    const Eigen::Vector2d at = pixelOf(vertex);
    EXPECT_LT(toEdge(at, pixels), tolerance)
        << "a vertex at " << at.transpose() << ", " << around << " m around";
  }
  const double area = areaAbout(wallAt(1.0).normal, ring);
  EXPECT_GT(area, 0.0) << "clockwise, " << around << " m around";
  EXPECT_NEAR(area / areaOf(pixels, 1.0), 1.0, 0.05) << around << " m around";
  for (const int u : {pixels.left, pixels.right}) {
    for (const int v : {pixels.top, pixels.bottom}) {
      // A corner is cut between the last row of samples and the last column.
      EXPECT_LT(toPoint(ring, Eigen::Vector2d(u, v)), 5.2)
          << "corner " << u << ", " << v << ", " << around << " m around";
    }
  }
}

TEST_P(Rectangle, HasItsBoundaryWhereItEnds)
{
  for (const float around : {test::kNoReturn, 2.0F, 0.5F}) expectBoundary(GetParam(), around, 1.01);
}

TEST_P(Rectangle, HasItWhereItEndsBeforeAWallThatIsNear)
{
  expectBoundary(GetParam(), 1.05F, 2.01);
}

INSTANTIATE_TEST_SUITE_P(PieceBoundary, Rectangle,
                         testing::Values(Pixels{30, 120, 20, 90}, Pixels{31, 121, 21, 91},
                                         Pixels{32, 123, 23, 93}, Pixels{33, 124, 22, 94},
                                         Pixels{29, 118, 19, 89}, Pixels{65, 89, 50, 69}));

TEST(PieceBoundary, AWallThatFillsTheImageEndsWithIt)
{
  test::PlaneScene scene;
  scene.add(wallAt(1.0));
  const Ring ring = boundaryAt(scene, 16, 16);
  const Pixels image{0, 159, 0, 119};
  expectOnPlane(ring, wallAt(1.0));
  for (const auto& vertex : ring)
    EXPECT_LT(toEdge(pixelOf(vertex), image), 0.01) << pixelOf(vertex).transpose();
  EXPECT_NEAR(areaAbout(wallAt(1.0).normal, ring), areaOf(image, 1.0), 1e-4);
}

TEST(PieceBoundary, AnLStaysAnL)
{
  // The lower right quarter is missing.
  test::PlaneScene scene;
  const Pixels whole{30, 130, 15, 105};
  const Pixels missing{80, 130, 60, 105};
  paint(scene, {0, 159, 0, 119}, 2.0F);
  paint(scene, whole, 1.0F);
  paint(scene, missing, 2.0F);
  const Ring ring = boundaryAt(scene, 10, 10);
  expectOnPlane(ring, wallAt(1.0));
  for (const auto& vertex : ring) {
    const Eigen::Vector2d at = pixelOf(vertex);
    const bool is_in_missing = at.x() > 78.0 && at.y() > 58.0;
    const double off = is_in_missing ? toEdge(at, {79, 200, 59, 200}) : toEdge(at, whole);
    EXPECT_LT(std::min(off, toEdge(at, {79, 130, 59, 105})), 1.01) << "a vertex at " << at.transpose();
  }
  EXPECT_LT(toPoint(ring, Eigen::Vector2d(79.0, 59.0)), 5.2) << "the corner that points inwards";
  const double area = areaOf(whole, 1.0) - areaOf(missing, 1.0);
  EXPECT_NEAR(areaAbout(wallAt(1.0).normal, ring) / area, 1.0, 0.05) << "of the L, of its hull 1.33";
}

TEST(PieceBoundary, OfAFloorItIsOnTheFloorAndCounterClockwise)
{
  const geometry::Plane floor = test::floorSeenFrom(0.8, 0.6, 0.2);
  test::PlaneScene scene;
  scene.add(floor, [](const Eigen::Vector3d& p) { return p.z() < 2.0; });
  const Ring ring = boundaryAt(scene, 16, 28);
  expectOnPlane(ring, floor);
  EXPECT_GT(areaAbout(floor.normal, ring), 0.5) << "m^2";
}

TEST(PieceBoundary, WhatStandsBeforeTheMiddleLeavesNoHole)
{
  test::PlaneScene scene;
  scene.add(wallAt(1.0));
  paint(scene, around(10, 20, 10, 20), 0.6F);
  const Ring ring = boundaryAt(scene, 2, 2);
  const Pixels image{0, 159, 0, 119};
  EXPECT_NEAR(areaAbout(wallAt(1.0).normal, ring), areaOf(image, 1.0), 1e-4);
  for (const auto& vertex : ring)
    EXPECT_LT(toEdge(pixelOf(vertex), image), 0.01) << pixelOf(vertex).transpose();
}

TEST(PieceBoundary, WhereALegIsBridgedItGoesStraightPast)
{
  // A leg from the image's top to its bottom: cells that are before the wall make no vertex.
  test::PlaneScene scene;
  scene.add(wallAt(1.0));
  const Pixels leg{test::columnOf(16) - 2, test::columnOf(16) + 2, 0, 119};
  paint(scene, leg, 0.5F);
  const Ring ring = boundaryAt(scene, 4, 4);
  expectOnPlane(ring, wallAt(1.0));
  EXPECT_NEAR(areaAbout(wallAt(1.0).normal, ring), areaOf({0, 159, 0, 119}, 1.0), 1e-4);
  for (const auto& vertex : ring) {
    const Eigen::Vector2d at = pixelOf(vertex);
    EXPECT_TRUE(at.x() < leg.left - 0.5 || at.x() > leg.right + 0.5) << "a vertex at " << at.transpose();
  }
}

TEST(PieceBoundary, TheLastPixelsOfAPlaneAreFoundBeforeAnotherThatIsNear)
{
  // A step of 3 cm, between two columns of samples.
  test::PlaneScene scene;
  paint(scene, {0, 84, 0, 119}, 1.0F);
  paint(scene, {85, 159, 0, 119}, 1.03F);
  for (const auto& [column, depth, right] : {std::tuple{4, 1.0, 84.0}, std::tuple{27, 1.03, 159.0}}) {
    const Ring ring = boundaryAt(scene, column, 16);
    expectOnPlane(ring, wallAt(depth));
    double farthest = 0.0;
    for (const auto& vertex : ring) farthest = std::max(farthest, pixelOf(vertex).x());
    EXPECT_NEAR(farthest, right, 0.1) << "of the wall at " << depth << " m";
  }
}

TEST(PieceBoundary, TheAxesOfACloudDoNotMatter)
{
  // x ahead, y to the left, z up.
  test::PlaneScene scene;
  paint(scene, {30, 120, 20, 90}, 1.0F);
  struct Point
  {
    float x, y, z;
  };
  std::vector<Point> cloud;
  const PointView optical = scene.view();
  for (std::uint32_t v = 0; v < 120; ++v) {
    for (std::uint32_t u = 0; u < 160; ++u) {
      const Eigen::Vector3f p = optical.point(u, v);
      cloud.push_back({p.z(), -p.x(), -p.y()});
    }
  }
  const PointView points = PointView::points(cloud.data(), 160, 120);
  ExtractedScene seen(scene);
  seen.update(points);
  const Ring ring = boundaryAt(seen, points, 14, 14);
  expectOnPlane(ring, {-Eigen::Vector3d::UnitX(), 1.0});
  EXPECT_NEAR(areaAbout(-Eigen::Vector3d::UnitX(), ring) / areaOf({30, 120, 20, 90}, 1.0), 1.0, 0.05);
}

TEST(PieceBoundary, WhatStandsInTheListStays)
{
  test::PlaneScene scene;
  paint(scene, {30, 120, 20, 90}, 1.0F);
  const ExtractedScene seen(scene);
  ASSERT_EQ(seen.pieces.pieces().size(), 1U);
  Ring once;
  PieceBoundary boundary;
  const auto trace = [&](Ring& ring) {
    boundary.trace(scene.view(), seen.grid, seen.lookup, seen.pieces.cells().data(), seen.pieces.pieces()[0],
                   wallAt(1.0), ring);
  };
  trace(once);
  Ring twice = once;
  trace(twice);
  Ring expected = once;
  expected.insert(expected.end(), once.begin(), once.end());
  EXPECT_EQ(twice, expected) << "the ring is appended, whatever came before";
}

TEST(PieceBoundary, APieceOfWhichNothingLiesOnThePlaneHasNone)
{
  test::PlaneScene scene;
  scene.add(wallAt(1.0));
  ExtractedScene seen(scene);
  seen.lookup.set(0, wallAt(1.5));
  EXPECT_TRUE(boundaryAt(seen, scene.view(), 16, 16).empty());
}

}  // namespace
}  // namespace polygonal_perception::perception

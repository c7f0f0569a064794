#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "polygonal_perception/geometry/distance.hpp"

namespace polygonal_perception::geometry {
namespace {

using Vertices = std::vector<Eigen::Vector2d>;

PolygonSet squareWithHole()
{
  PolygonSet polygons;
  polygons.append(Vertices{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, false);
  polygons.append(Vertices{{2, 2}, {2, 6}, {6, 6}, {6, 2}}, true);
  return polygons;
}

void expectNearest(const Eigen::Vector2d& p, const Eigen::Vector2d& point, std::uint32_t ring,
                   std::uint32_t edge)
{
  const PolygonSet polygons = squareWithHole();
  const auto nearest = nearestBoundaryPoint(p, polygons);
  ASSERT_TRUE(nearest);
  EXPECT_EQ(nearest->point, point) << nearest->point.transpose();
  EXPECT_EQ(nearest->ring, ring);
  EXPECT_EQ(nearest->edge, edge);
  EXPECT_DOUBLE_EQ(nearest->distance, (p - point).norm());
  EXPECT_DOUBLE_EQ(distanceToBoundary(p, polygons), (p - point).norm());
}

TEST(Distance, TheNearestPointHasItsRingAndEdge)
{
  expectNearest({9, 3}, {8, 3}, 0, 1);          // outside
  expectNearest({0.5, 3}, {0, 3}, 0, 3);        // inside, by the last edge
  expectNearest({4, 5.5}, {4, 6}, 1, 1);        // in the hole
  expectNearest({11, 12}, {8, 8}, 0, 1);        // at a corner: the first of its edges
  expectNearest({-0.25, 0.5}, {0, 0.5}, 0, 3);  // the last edge again, from outside
  expectNearest({6, 2}, {6, 2}, 1, 2);          // on a vertex
}

TEST(Distance, WithoutPolygonsItIsInfinite)
{
  EXPECT_FALSE(nearestBoundaryPoint({0, 0}, PolygonSet()));
  EXPECT_EQ(distanceToBoundary({0, 0}, PolygonSet()), std::numeric_limits<double>::infinity());
}

TEST(Distance, ToASegmentAndToASinglePoint)
{
  EXPECT_EQ(nearestOnSegment({1, 1}, {0, 0}, {4, 0}), Eigen::Vector2d(1, 0));
  EXPECT_EQ(nearestOnSegment({-1, 1}, {0, 0}, {4, 0}), Eigen::Vector2d(0, 0));
  EXPECT_EQ(nearestOnSegment({9, 1}, {0, 0}, {4, 0}), Eigen::Vector2d(4, 0));
  EXPECT_EQ(nearestOnSegment({9, 1}, {3, 3}, {3, 3}), Eigen::Vector2d(3, 3));
  EXPECT_EQ(distanceToBoundary({3, 7}, Vertices{{3, 3}}), 4.0) << "a ring of one vertex";
}

TEST(Distance, NoSampleOfTheBoundaryIsNearer)
{
  const PolygonSet polygons = squareWithHole();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(-3.0, 11.0);
  constexpr int kSamples = 400;
  for (int n = 0; n < 300; ++n) {
    const Eigen::Vector2d p(anywhere(random), anywhere(random));
    double sampled = std::numeric_limits<double>::infinity();
    for (const PolygonSet::Ring& ring : polygons.rings) {
      for (const auto [from, to] : polygons.view(ring).edges()) {
        for (int s = 0; s < kSamples; ++s)
          sampled = std::min(sampled, (from + (to - from) * s / kSamples - p).norm());
      }
    }
    const double distance = distanceToBoundary(p, polygons);
    ASSERT_LE(distance, sampled + 1e-12) << p.transpose();
    ASSERT_GE(distance, sampled - 8.0 / kSamples) << p.transpose();
  }
}

}  // namespace
}  // namespace polygonal_perception::geometry

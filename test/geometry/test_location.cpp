#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "polygonal_perception/geometry/location.hpp"

namespace polygonal_perception::geometry {
namespace {

using Vertices = std::vector<Eigen::Vector2d>;

/// A square with a hole in which another polygon stands.
PolygonSet nested()
{
  PolygonSet polygons;
  polygons.append(Vertices{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, false);
  polygons.append(Vertices{{2, 2}, {2, 6}, {6, 6}, {6, 2}}, true);
  polygons.append(Vertices{{3, 3}, {5, 3}, {4, 5}}, false);
  return polygons;
}

TEST(Location, InsideOnTheBoundaryOutside)
{
  const PolygonSet polygons = nested();
  EXPECT_EQ(locate({1, 4}, polygons), Location::kInside);
  EXPECT_EQ(locate({2.5, 4}, polygons), Location::kOutside) << "in the hole";
  EXPECT_EQ(locate({4, 4}, polygons), Location::kInside) << "in what stands in the hole";
  EXPECT_EQ(locate({9, 4}, polygons), Location::kOutside);
  EXPECT_EQ(locate({-1, 8}, polygons), Location::kOutside) << "beside an edge, at its height";
  EXPECT_EQ(locate({8, 4}, polygons), Location::kBoundary);
  EXPECT_EQ(locate({0, 0}, polygons), Location::kBoundary) << "a vertex";
  EXPECT_EQ(locate({2, 3}, polygons), Location::kBoundary) << "on a hole's edge";
  EXPECT_EQ(locate({0, 0}, PolygonSet()), Location::kOutside);
}

TEST(Location, ARayThroughVerticesIsCountedOnce)
{
  const Vertices diamond = {{0, -2}, {2, 0}, {0, 2}, {-2, 0}};
  EXPECT_EQ(locate({-1, 0}, RingView(diamond)), Location::kInside);
  EXPECT_EQ(locate({-3, 0}, RingView(diamond)), Location::kOutside);
  EXPECT_EQ(locate({-1, 2}, RingView(diamond)), Location::kOutside) << "past the tip";
  EXPECT_EQ(locate({-1, -2}, RingView(diamond)), Location::kOutside) << "past the tip";
  const Vertices steps = {{0, 0}, {4, 0}, {4, 2}, {3, 2}, {3, 1}, {1, 1}, {1, 2}, {0, 2}};
  EXPECT_EQ(locate({0.5, 1}, RingView(steps)), Location::kInside) << "through a level edge";
  EXPECT_EQ(locate({2, 2}, RingView(steps)), Location::kOutside) << "between two level edges";
}

TEST(Location, TheOrientationDoesNotMatter)
{
  const Vertices clockwise = {{0, 0}, {0, 2}, {2, 0}};
  EXPECT_EQ(locate({0.5, 0.5}, RingView(clockwise)), Location::kInside);
}

TEST(Location, AnUlpDecides)
{
  // The edge from (0, 0) to (3, 1) passes (1.5, 0.5) exactly.
  const Vertices triangle = {{0, 0}, {3, 1}, {0, 3}};
  EXPECT_EQ(locate({1.5, 0.5}, RingView(triangle)), Location::kBoundary);
  EXPECT_EQ(locate({1.5, 0.5 + 0x1p-53}, RingView(triangle)), Location::kInside);
  EXPECT_EQ(locate({1.5, 0.5 - 0x1p-54}, RingView(triangle)), Location::kOutside);
}

/// The angle by which a ring turns around a point is the oracle.
TEST(Location, OfRandomStarsAsByTheWindingNumber)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> radius(1.0, 10.0);
  std::uniform_real_distribution<double> anywhere(-11.0, 11.0);
  for (int round = 0; round < 200; ++round) {
    Vertices star;
    for (int k = 0; k < 17; ++k)
      star.push_back(radius(random) *
                     Eigen::Vector2d(std::cos(2 * M_PI * k / 17), std::sin(2 * M_PI * k / 17)));
    for (int n = 0; n < 100; ++n) {
      const Eigen::Vector2d p(anywhere(random), anywhere(random));
      double turned = 0.0;
      for (const auto [from, to] : RingView(star).edges()) {
        const Eigen::Vector2d a = from - p, b = to - p;
        turned += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
      }
      ASSERT_EQ(locate(p, RingView(star)), turned > M_PI ? Location::kInside : Location::kOutside)
          << p.transpose() << " in round " << round;
    }
    for (const Eigen::Vector2d& vertex : star) ASSERT_EQ(locate(vertex, RingView(star)), Location::kBoundary);
  }
}

}  // namespace
}  // namespace polygonal_perception::geometry

#include <gtest/gtest.h>

#include <random>

#include "polygonal_perception/geometry/triangulation.hpp"
#include "polygonal_perception/occupancy/grid/inflation.hpp"
#include "polygonal_perception/occupancy/polygons/polygonizer.hpp"

namespace polygonal_perception::geometry {
namespace {

using Ring = std::vector<Eigen::Vector2d>;

void append(PolygonSet& set, const Ring& ring, bool hole)
{
  set.rings.push_back(
      {static_cast<std::uint32_t>(set.vertices.size()), static_cast<std::uint32_t>(ring.size()), hole});
  set.vertices.insert(set.vertices.end(), ring.begin(), ring.end());
}

PolygonSet polygon(const Ring& boundary, const std::vector<Ring>& holes = {})
{
  PolygonSet set;
  append(set, boundary, false);
  for (const Ring& hole : holes) append(set, hole, true);
  return set;
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/// Holes run clockwise and so count as negative.
double areaOf(const PolygonSet& set)
{
  double area = 0.0;
  for (const PolygonSet::Ring& ring : set.rings) {
    for (std::uint32_t i = 0; i < ring.size; ++i) {
      area += cross(set.vertices[ring.first + i], set.vertices[ring.first + (i + 1) % ring.size]) / 2.0;
    }
  }
  return area;
}

/// Whether p is inside by the even-odd rule.
bool inside(const PolygonSet& set, const Eigen::Vector2d& p)
{
  bool in = false;
  for (const PolygonSet::Ring& ring : set.rings) {
    for (std::uint32_t i = 0; i < ring.size; ++i) {
      const Eigen::Vector2d& a = set.vertices[ring.first + i];
      const Eigen::Vector2d& b = set.vertices[ring.first + (i + 1) % ring.size];
      if ((a.y() > p.y()) != (b.y() > p.y()) &&
          p.x() < a.x() + (p.y() - a.y()) * (b.x() - a.x()) / (b.y() - a.y())) {
        in = !in;
      }
    }
  }
  return in;
}

/// Every triangle runs counter-clockwise with its centre in the polygons, and together they have their area:
/// so they cover them, each place once.
void expectCover(const PolygonSet& set)
{
  const std::vector<Eigen::Vector2d> triangles = triangulate(set);
  ASSERT_EQ(triangles.size() % 3, 0U);
  EXPECT_LE(triangles.size() / 3, 2 * set.vertices.size());
  double area = 0.0;
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    const Eigen::Vector2d& a = triangles[t];
    const Eigen::Vector2d& b = triangles[t + 1];
    const Eigen::Vector2d& c = triangles[t + 2];
    const double twice = cross(b - a, c - a);
    EXPECT_GT(twice, 0.0);
    EXPECT_TRUE(inside(set, (a + b + c) / 3.0))
        << a.transpose() << ", " << b.transpose() << ", " << c.transpose();
    area += twice / 2.0;
  }
  EXPECT_NEAR(area, areaOf(set), 1e-9 * (1.0 + areaOf(set)));
}

const Ring kSquare = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};

TEST(Triangulation, NothingGivesNothing)
{
  EXPECT_TRUE(triangulate(PolygonSet()).empty());
}

TEST(Triangulation, ATriangleIsItself)
{
  EXPECT_EQ(triangulate(polygon({{0, 0}, {1, 0}, {0, 1}})).size(), 3U);
  expectCover(polygon({{0, 0}, {1, 0}, {0, 1}}));
}

TEST(Triangulation, ASquareTakesTwo)
{
  EXPECT_EQ(triangulate(polygon(kSquare)).size(), 6U);
}

TEST(Triangulation, NonConvexBoundariesAreCovered)
{
  expectCover(polygon({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}));                  // an L
  expectCover(polygon({{0, 0}, {4, 0}, {4, 3}, {3, 3}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}));  // a U
  expectCover(polygon({{0, 0}, {5, 2}, {10, 0}, {6, 3}, {5, 9}, {4, 3}}));                 // a star
}

TEST(Triangulation, VerticesInAStraightLineDoNoHarm)
{
  expectCover(polygon({{0, 0}, {1, 0}, {2, 0}, {4, 0}, {4, 2}, {4, 4}, {0, 4}, {0, 1}}));
}

TEST(Triangulation, AHoleIsLeftOpen)
{
  const PolygonSet ring = polygon(kSquare, {{{1, 1}, {1, 3}, {3, 3}, {3, 1}}});
  EXPECT_DOUBLE_EQ(areaOf(ring), 12.0);
  expectCover(ring);
}

TEST(Triangulation, HolesBehindOneAnotherAndSideBySide)
{
  expectCover(polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{{1, 1}, {1, 3}, {3, 3}, {3, 1}},
                                                             {{5, 1}, {5, 3}, {7, 3}, {7, 1}},
                                                             {{8, 1}, {8, 3}, {9, 3}, {9, 1}},
                                                             {{5, 5}, {5, 9}, {7, 7}},
                                                             {{1, 5}, {1, 9}, {4, 9}, {4, 5}}}));
}

TEST(Triangulation, AHoleThatTouchesTheBoundaryInACorner)
{
  expectCover(polygon({{0, 0}, {4, 0}, {4, 4}, {2, 3}, {0, 4}}, {{{2, 3}, {3, 1}, {1, 1}}}));
  expectCover(polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 2}, {3, 3}, {4, 2}, {3, 1}}}));
}

TEST(Triangulation, SeveralPolygonsOneAfterTheOther)
{
  PolygonSet set = polygon(kSquare, {{{1, 1}, {1, 3}, {3, 3}, {3, 1}}});
  append(set, {{5, 0}, {6, 0}, {6, 1}}, false);
  append(set, {{7, 0}, {9, 0}, {9, 2}, {8, 1}, {7, 2}}, false);
  expectCover(set);
}

TEST(Triangulation, ARingThatCrossesItselfStillEnds)
{
  EXPECT_LE(triangulate(polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}})).size() / 3, 8U);
  EXPECT_TRUE(triangulate(polygon({{0, 0}, {1, 0}, {2, 0}})).empty());
}

class TriangulationOfGrids : public testing::TestWithParam<double>
{
};

TEST_P(TriangulationOfGrids, CoversWhatThePolygonizerGives)
{
  const double robot_radius = GetParam();
  occupancy::GridParameters size;
  size.grid_length = size.grid_width = 2.0;
  occupancy::Polygonizer polygonizer(occupancy::Polygonizer::Parameters{});
  occupancy::Inflation inflation(occupancy::Inflation::Parameters{robot_radius});
  std::mt19937 random(7);
  for (int round = 0; round < 60; ++round) {
    occupancy::BinaryGrid occupancy{occupancy::GridGeometry(size)};
    std::bernoulli_distribution is_occupied(0.01 * (1 + round));
    for (int j = 0; j < occupancy.cellsY(); ++j) {
      for (int i = 0; i < occupancy.cellsX(); ++i) occupancy.set(i, j, is_occupied(random));
    }
    occupancy::BinaryGrid inflated;
    PolygonSet polygons;
    inflation.inflate(occupancy, inflated);
    polygonizer.polygonize(occupancy, inflated, robot_radius, polygons);
    expectCover(polygons);
    if (HasFailure()) FAIL() << "in round " << round << " with robot_radius " << robot_radius;
  }
}

INSTANTIATE_TEST_SUITE_P(Radii, TriangulationOfGrids, testing::Values(0.0, 0.04, 0.1));

}  // namespace
}  // namespace polygonal_perception::geometry

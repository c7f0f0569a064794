#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "polygonal_perception/geometry/validity.hpp"

namespace polygonal_perception::geometry {
namespace {

using Vertices = std::vector<Eigen::Vector2d>;
struct Ring
{
  Vertices vertices;
  bool hole = false;
};

PolygonSet setOf(const std::vector<Ring>& rings)
{
  PolygonSet polygons;
  for (const Ring& ring : rings) polygons.append(ring.vertices, ring.hole);
  return polygons;
}

const Vertices kSquare = {{0, 0}, {8, 0}, {8, 8}, {0, 8}};
const Vertices kHole = {{2, 2}, {2, 6}, {6, 6}, {6, 2}};
const Vertices kInHole = {{3, 3}, {5, 3}, {4, 5}};

void expectDefect(const std::vector<Ring>& rings, Defect defect, std::uint32_t ring,
                  const Eigen::Vector2d& place)
{
  const auto found = findDefect(setOf(rings));
  ASSERT_TRUE(found) << "taken for valid";
  EXPECT_EQ(found->defect, defect) << found->text;
  EXPECT_EQ(found->ring, ring) << found->text;
  EXPECT_EQ(found->place, place) << found->text;
  EXPECT_NE(found->text.find("ring " + std::to_string(ring)), std::string::npos) << found->text;
}

TEST(Validity, ValidSets)
{
  for (const std::vector<Ring>& rings :
       std::vector<std::vector<Ring>>{{},
                                      {{kSquare}},
                                      {{kSquare}, {kHole, true}},
                                      {{kSquare}, {kHole, true}, {kInHole}},
                                      {{kInHole}, {kSquare}, {kHole, true}},
                                      {{{{0, 0}, {4, 0}, {8, 0}, {8, 8}}}},  // a vertex in a straight line
                                      {{kSquare}, {{{9, 0}, {10, 0}, {10, 8}, {9, 8}}}}})  // side by side
  {
    const auto found = findDefect(setOf(rings));
    EXPECT_FALSE(found) << found->text;
  }
}

TEST(Validity, BadVertices)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expectDefect({{kSquare}, {{{1, 1}, {2, 2}}, true}}, Defect::kTooFewVertices, 1, {1, 1});
  expectDefect({{{}}}, Defect::kTooFewVertices, 0, {0, 0});
  expectDefect({{{{0, 0}, {1, 0}, {1, 1}, {1, 1}}}}, Defect::kRepeatedVertex, 0, {1, 1});
  expectDefect({{{{0, 0}, {1, 0}, {1, 1}, {0, 0}}}}, Defect::kRepeatedVertex, 0, {0, 0});
  const auto found = findDefect(setOf({{{{0, 0}, {1, nan}, {1, 1}}}}));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->defect, Defect::kNotFinite);
}

TEST(Validity, ARingThatMeetsItself)
{
  const Defect defect = Defect::kRingMeetsItself;
  expectDefect({{{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}}, defect, 0, {2, 2});          // crosses
  expectDefect({{{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}}}, defect, 0, {2, 0});  // a vertex on an edge
  expectDefect({{{{0, 0}, {4, 0}, {2, 0}, {2, 3}}}}, defect, 0, {4, 0});          // folds back
  expectDefect({{{{0, 0}, {2, 0}, {1, 0}}}}, defect, 0, {1, 0});                  // has no area
  expectDefect({{{{0, 0}, {2, 2}, {4, 0}, {4, 4}, {2, 2}, {0, 4}}}}, defect, 0,
               {2, 2});  // a vertex on a vertex
}

TEST(Validity, RingsThatMeet)
{
  const Defect defect = Defect::kRingsMeet;
  expectDefect({{kSquare}, {{{4, 4}, {12, 4}, {4, 5}}}}, defect, 0, {8, 4});
  expectDefect({{kSquare}, {{{8, 8}, {12, 8}, {12, 12}}}}, defect, 0, {8, 8});         // in a corner
  expectDefect({{kSquare}, {{{2, 2}, {2, 8}, {6, 2}}, true}}, defect, 0, {2, 8});      // its hole
  expectDefect({{kSquare}, {{{8, 2}, {12, 2}, {12, 4}, {8, 4}}}}, defect, 0, {8, 4});  // along an edge
}

TEST(Validity, WrongOrientation)
{
  expectDefect({{{kSquare.rbegin(), kSquare.rend()}}}, Defect::kWrongOrientation, 0, {0, 8});
  expectDefect({{kSquare}, {{kHole.rbegin(), kHole.rend()}, true}}, Defect::kWrongOrientation, 1, {6, 2});
  const Vertices upright_first = {{0, 0}, {1, 1}, {0, 4}, {0, 2}};  // leftmost vertices in a line
  EXPECT_FALSE(findDefect(setOf({{upright_first}})));
}

TEST(Validity, WrongNesting)
{
  expectDefect({{kHole, true}}, Defect::kHoleOutside, 0, {2, 2});
  expectDefect({{{{20, 0}, {28, 0}, {28, 8}}}, {kHole, true}}, Defect::kHoleOutside, 1, {2, 2});
  expectDefect({{kInHole}, {kHole, true}}, Defect::kHoleOutside, 1, {2, 2});
  expectDefect({{kSquare}, {kHole, true}, {{kInHole.rbegin(), kInHole.rend()}, true}}, Defect::kHoleOutside,
               2, {4, 5});
  expectDefect({{kSquare}, {kInHole}}, Defect::kPolygonsOverlap, 1, {3, 3});
  expectDefect({{kInHole}, {kSquare}}, Defect::kPolygonsOverlap, 0, {3, 3});
  expectDefect({{kSquare}, {kHole, true}, {kInHole}, {{{3.5, 3.25}, {4.5, 3.25}, {4, 4}}}},
               Defect::kPolygonsOverlap, 3, {3.5, 3.25});
}

/// Squares around one point, each in the one before it: boundaries and holes in turn.
PolygonSet squares(int count)
{
  PolygonSet polygons;
  for (int k = 0; k < count; ++k) {
    const double side = count - k;
    Vertices square = {{-side, -side}, {side, -side}, {side, side}, {-side, side}};
    if (k % 2 == 1) std::reverse(square.begin(), square.end());
    polygons.append(square, k % 2 == 1);
  }
  return polygons;
}

TEST(Validity, RingsDeepInOneAnother)
{
  PolygonSet polygons = squares(3000);
  const auto found = findDefect(polygons);
  EXPECT_FALSE(found) << found->text;
  // Without one of the holes, what was in it lies in the polygon itself.
  polygons.rings.erase(polygons.rings.begin() + 1001);
  const auto overlap = findDefect(polygons);
  ASSERT_TRUE(overlap);
  EXPECT_EQ(overlap->text, "ring 1001 lies inside of the polygon of ring 1000 at (-1998, -1998)");
}

/// Stars in the cells of a lattice, which cannot meet.
PolygonSet stars(int cells, std::mt19937& random)
{
  std::uniform_real_distribution<double> radius(0.1, 0.49);
  PolygonSet polygons;
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      Vertices star;
      for (int k = 0; k < 10; ++k) {
        const double angle = 0.2 * M_PI * k;
        star.push_back(Eigen::Vector2d(i, j) +
                       radius(random) * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
      }
      polygons.append(star, false);
    }
  }
  return polygons;
}

TEST(Validity, OneVertexOfRandomStarsMovedIntoAnother)
{
  std::mt19937 random(2);
  for (int round = 0; round < 200; ++round) {
    PolygonSet polygons = stars(5, random);
    ASSERT_FALSE(findDefect(polygons)) << "round " << round << ": " << findDefect(polygons)->text;
    const std::size_t ring = random() % polygons.rings.size();
    polygons.vertices[polygons.rings[ring].first] = {ring == 0 ? 4.0 : 0.0, 0.0};  // another star's middle
    const auto found = findDefect(polygons);
    ASSERT_TRUE(found) << "round " << round << ", ring " << ring;
    EXPECT_TRUE(found->defect == Defect::kRingsMeet || found->defect == Defect::kRingMeetsItself)
        << found->text;
  }
}

}  // namespace
}  // namespace polygonal_perception::geometry

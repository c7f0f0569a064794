#include <gtest/gtest.h>

#include <array>
#include <random>
#include <sstream>

#include "polygonal_perception/geometry/predicates.hpp"

namespace polygonal_perception::geometry {
namespace {

using Contact = SegmentContact;

Contact contact(const std::array<Eigen::Vector2d, 4>& p)
{
  return segmentContact(p[0], p[1], p[2], p[3]);
}

TEST(Segments, ApartCrossingTouchingOverlapping)
{
  EXPECT_EQ(contact({{{0, 0}, {1, 0}, {0, 1}, {1, 1}}}), Contact::kNone) << "parallel";
  EXPECT_EQ(contact({{{0, 0}, {4, 4}, {3, 0}, {4, 1}}}), Contact::kNone) << "their boxes overlap";
  EXPECT_EQ(contact({{{0, 0}, {2, 2}, {0, 2}, {2, 0}}}), Contact::kCross);
  EXPECT_EQ(contact({{{0, 0}, {2, 0}, {1, 0}, {1, 2}}}), Contact::kTouch) << "an end on the inside";
  EXPECT_EQ(contact({{{0, 0}, {2, 0}, {2, 0}, {3, 5}}}), Contact::kTouch) << "two ends";
  EXPECT_EQ(contact({{{0, 0}, {2, 0}, {1, 0}, {3, 0}}}), Contact::kOverlap);
  EXPECT_EQ(contact({{{0, 0}, {4, 0}, {3, 0}, {1, 0}}}), Contact::kOverlap) << "one in the other";
  EXPECT_EQ(contact({{{0, 0}, {2, 0}, {2, 0}, {0, 0}}}), Contact::kOverlap) << "the same, turned";
  EXPECT_EQ(contact({{{0, 0}, {2, 2}, {2, 2}, {3, 3}}}), Contact::kTouch) << "on one line, end to end";
  EXPECT_EQ(contact({{{0, 0}, {2, 2}, {3, 3}, {4, 4}}}), Contact::kNone) << "on one line, apart";
}

TEST(Segments, SinglePoints)
{
  EXPECT_EQ(contact({{{1, 1}, {1, 1}, {0, 0}, {2, 2}}}), Contact::kTouch);
  EXPECT_EQ(contact({{{1, 0}, {1, 0}, {0, 0}, {2, 2}}}), Contact::kNone);
  EXPECT_EQ(contact({{{1, 1}, {1, 1}, {1, 1}, {1, 1}}}), Contact::kTouch);
  EXPECT_EQ(contact({{{1, 1}, {1, 1}, {1, 2}, {1, 2}}}), Contact::kNone);
}

TEST(Segments, AnUlpDecides)
{
  // From (0, 0) to (3, 1) the height at 1.5 is exactly 0.5; an end there touches, one an ulp above does not.
  const double above = 0.5 + 0x1p-53;
  EXPECT_EQ(contact({{{0, 0}, {3, 1}, {1.5, 0.5}, {1.5, 4}}}), Contact::kTouch);
  EXPECT_EQ(contact({{{0, 0}, {3, 1}, {1.5, above}, {1.5, 4}}}), Contact::kNone);
  EXPECT_EQ(contact({{{0, 0}, {3, 1}, {1.5, 0.5 - 0x1p-54}, {1.5, 4}}}), Contact::kCross);
  EXPECT_TRUE(isOnSegment({1.5, 0.5}, {0, 0}, {3, 1}));
  EXPECT_FALSE(isOnSegment({1.5, above}, {0, 0}, {3, 1}));
}

TEST(Segments, APointOnASegment)
{
  EXPECT_TRUE(isOnSegment({1, 1}, {0, 0}, {2, 2}));
  EXPECT_TRUE(isOnSegment({0, 0}, {0, 0}, {2, 2}));
  EXPECT_TRUE(isOnSegment({2, 2}, {0, 0}, {2, 2}));
  EXPECT_FALSE(isOnSegment({3, 3}, {0, 0}, {2, 2})) << "on its line, beyond its end";
  EXPECT_TRUE(isOnSegment({5, 5}, {5, 5}, {5, 5}));
  EXPECT_FALSE(isOnSegment({5, 6}, {5, 5}, {5, 5}));
}

struct Lattice
{
  std::int64_t x, y;
};
using Quadruple = std::array<Lattice, 4>;

std::int64_t cross(Lattice a, Lattice b, Lattice c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Another way, in whole numbers: the points of a + s (b - a) = c + t (d - c), by Cramer's rule.
Contact wholeContact(const Quadruple& p)
{
  const auto [a, b, c, d] = p;
  const std::int64_t determinant = (b.x - a.x) * (d.y - c.y) - (b.y - a.y) * (d.x - c.x);
  if (determinant != 0) {
    const std::int64_t sign = determinant > 0 ? 1 : -1;
    const std::int64_t limit = sign * determinant;
    const std::int64_t s = sign * ((c.x - a.x) * (d.y - c.y) - (c.y - a.y) * (d.x - c.x));
    const std::int64_t t = sign * ((c.x - a.x) * (b.y - a.y) - (c.y - a.y) * (b.x - a.x));
    if (s < 0 || s > limit || t < 0 || t > limit) return Contact::kNone;
    return s > 0 && s < limit && t > 0 && t < limit ? Contact::kCross : Contact::kTouch;
  }
  const bool first_is_point = a.x == b.x && a.y == b.y;
  if (first_is_point && c.x == d.x && c.y == d.y)
    return a.x == c.x && a.y == c.y ? Contact::kTouch : Contact::kNone;
  // Parallel: along the one that has a length, from its begin.
  const Lattice from = first_is_point ? c : a;
  const Lattice to = first_is_point ? d : b;
  const Lattice p_other = first_is_point ? a : c;
  const Lattice q_other = first_is_point ? b : d;
  if (cross(from, to, p_other) != 0) return Contact::kNone;
  const auto along = [&](Lattice q) {
    return (q.x - from.x) * (to.x - from.x) + (q.y - from.y) * (to.y - from.y);
  };
  const std::int64_t begin = std::max<std::int64_t>(0, std::min(along(p_other), along(q_other)));
  const std::int64_t end = std::min(along(to), std::max(along(p_other), along(q_other)));
  if (begin > end) return Contact::kNone;
  return begin < end ? Contact::kOverlap : Contact::kTouch;
}

Contact contactOf(const Quadruple& p)
{
  const auto at = [&](int k) {
    return Eigen::Vector2d(static_cast<double>(p[k].x), static_cast<double>(p[k].y));
  };
  return contact({{at(0), at(1), at(2), at(3)}});
}

/// Moves coordinates towards 0 as long as the answer stays wrong.
Quadruple shrunk(Quadruple p)
{
  for (bool smaller = true; smaller;) {
    smaller = false;
    for (Lattice& point : p) {
      for (std::int64_t* value : {&point.x, &point.y}) {
        if (*value == 0) continue;
        const std::int64_t before = *value;
        *value += before > 0 ? -1 : 1;
        if (contactOf(p) != wholeContact(p)) {
          smaller = true;
        } else {
          *value = before;
        }
      }
    }
  }
  return p;
}

class SegmentsOfALattice : public testing::TestWithParam<int>
{
};

TEST_P(SegmentsOfALattice, AsInWholeNumbers)
{
  std::mt19937 random(static_cast<unsigned>(GetParam()));
  std::uniform_int_distribution<std::int64_t> coordinate(-GetParam(), GetParam());
  std::array<int, 4> seen{};
  for (int n = 0; n < 50000; ++n) {
    Quadruple p{};
    for (Lattice& point : p) point = {coordinate(random), coordinate(random)};
    ++seen[static_cast<std::size_t>(wholeContact(p))];
    if (contactOf(p) == wholeContact(p)) continue;
    p = shrunk(p);
    std::ostringstream text;
    for (const Lattice& point : p) text << " (" << point.x << ", " << point.y << ")";
    FAIL() << "segments" << text.str() << ": " << static_cast<int>(contactOf(p)) << ", in whole numbers "
           << static_cast<int>(wholeContact(p));
  }
  EXPECT_GT(seen[0], 0);
  EXPECT_GT(seen[2], 0);
  if (GetParam() < 10) {
    EXPECT_GT(seen[1], 0);
    EXPECT_GT(seen[3], 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, SegmentsOfALattice, testing::Values(1, 2, 4, 9, 1000));

}  // namespace
}  // namespace polygonal_perception::geometry

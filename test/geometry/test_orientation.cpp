#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <sstream>

#include "polygonal_perception/geometry/predicates.hpp"

namespace polygonal_perception::geometry {
namespace {

__extension__ using Wide = __int128;

struct Lattice
{
  std::int64_t x, y;
};
using Triple = std::array<Lattice, 3>;

/// The sign of (a - c) x (b - c) in whole numbers: no rounding for coordinates below 2^61.
Orientation wholeOrientation(const Triple& t)
{
  const Wide left = static_cast<Wide>(t[0].x - t[2].x) * (t[1].y - t[2].y);
  const Wide right = static_cast<Wide>(t[0].y - t[2].y) * (t[1].x - t[2].x);
  if (left == right) return Orientation::kCollinear;
  return left > right ? Orientation::kCounterClockwise : Orientation::kClockwise;
}

Eigen::Vector2d scaled(const Lattice& p, int exponent)
{
  return {std::ldexp(static_cast<double>(p.x), exponent), std::ldexp(static_cast<double>(p.y), exponent)};
}

Orientation orientationOf(const Triple& t, int exponent)
{
  return orientation(scaled(t[0], exponent), scaled(t[1], exponent), scaled(t[2], exponent));
}

bool isWrong(const Triple& t, int exponent)
{
  return orientationOf(t, exponent) != wholeOrientation(t);
}

/// Halves coordinates, or moves them one nearer to 0, as long as the answer stays wrong.
Triple shrunk(Triple t, int exponent)
{
  for (bool smaller = true; smaller;) {
    smaller = false;
    for (Lattice& p : t) {
      for (std::int64_t* value : {&p.x, &p.y}) {
        const std::int64_t before = *value;
        for (const std::int64_t step : {before - before / 2, std::int64_t{before > 0 ? 1 : -1}}) {
          if (before == 0) continue;
          *value = before - step;
          if (isWrong(t, exponent)) {
            smaller = true;
            break;
          }
          *value = before;
        }
      }
    }
  }
  return t;
}

void expectExact(const Triple& t, int exponent)
{
  if (!isWrong(t, exponent)) return;
  const Triple least = shrunk(t, exponent);
  std::ostringstream text;
  for (const Lattice& p : least) text << " (" << p.x << ", " << p.y << ")";
  ADD_FAILURE() << "orientation of" << text.str() << " times 2^" << exponent << " is "
                << static_cast<int>(orientationOf(least, exponent)) << ", in whole numbers "
                << static_cast<int>(wholeOrientation(least));
}

TEST(Orientation, ByHand)
{
  EXPECT_EQ(orientation({0, 0}, {1, 0}, {0, 1}), Orientation::kCounterClockwise);
  EXPECT_EQ(orientation({0, 0}, {0, 1}, {1, 0}), Orientation::kClockwise);
  EXPECT_EQ(orientation({0, 0}, {1, 1}, {3, 3}), Orientation::kCollinear);
  EXPECT_EQ(orientation({2, 3}, {2, 3}, {5, 7}), Orientation::kCollinear) << "two points are the same";
}

TEST(Orientation, OfARing)
{
  using Vertices = std::vector<Eigen::Vector2d>;
  const Vertices square = {{0, 0}, {8, 0}, {8, 8}, {0, 8}};
  EXPECT_EQ(orientation(square), Orientation::kCounterClockwise);
  EXPECT_EQ(orientation(Vertices(square.rbegin(), square.rend())), Orientation::kClockwise);
  const Vertices upright_first = {{0, 0}, {1, 1}, {0, 4}, {0, 2}};
  EXPECT_EQ(orientation(upright_first), Orientation::kCounterClockwise) << "leftmost vertices in a line";
  // Its area is 2^-53 of that of its box, and comes out as 0.
  const Vertices sliver = {{12, 12}, {24, 24}, {0.5, 0.5 + 0x1p-53}};
  EXPECT_EQ(orientation(sliver), Orientation::kCounterClockwise);
  EXPECT_EQ(orientation(Vertices{{0, 0}, {1, 1}, {2, 2}}), Orientation::kCollinear);
}

TEST(Orientation, OneUlpBesideALine)
{
  // The classic in which the plain formula is wrong: points around (0.5, 0.5) and the line to (24, 24).
  const double ulp = 0x1p-53;
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j < 64; ++j) {
      const auto expected = j > i   ? Orientation::kCounterClockwise
                            : j < i ? Orientation::kClockwise
                                    : Orientation::kCollinear;
      EXPECT_EQ(orientation({12, 12}, {24, 24}, {0.5 + i * ulp, 0.5 + j * ulp}), expected) << i << ' ' << j;
    }
  }
}

TEST(Orientation, MagnitudesThatDifferByFar)
{
  EXPECT_EQ(orientation({1e-100, 0}, {1e100, 1e100}, {0, 0}), Orientation::kCounterClockwise);
  EXPECT_EQ(orientation({1e-100, 1e-100}, {1e100, 1e100}, {0, 0}), Orientation::kCollinear);
  EXPECT_EQ(orientation({1e100, 1e100}, {-1e100, -1e100}, {1e-100, 0}), Orientation::kCounterClockwise);
  EXPECT_EQ(orientation({1e100, 1e100}, {-1e100, -1e100}, {0, 1e-100}), Orientation::kClockwise);
}

/// Coordinates of so many bits, at scales from 2^-200 to 2^200.
class OrientationOfWholeNumbers : public testing::TestWithParam<int>
{
protected:
  std::int64_t coordinate() { return std::uniform_int_distribution<std::int64_t>(-limit_, limit_)(random_); }
  Lattice point() { return {coordinate(), coordinate()}; }
  int exponent() { return std::uniform_int_distribution<int>(-200, 200)(random_); }

  std::int64_t limit_ = std::int64_t{1} << GetParam();
  std::mt19937_64 random_{static_cast<std::uint64_t>(GetParam())};
};

TEST_P(OrientationOfWholeNumbers, Anywhere)
{
  for (int n = 0; n < 20000 && !HasFailure(); ++n) expectExact({point(), point(), point()}, exponent());
}

TEST_P(OrientationOfWholeNumbers, NearlyOnALine)
{
  std::uniform_int_distribution<std::int64_t> beside(-1, 1);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  for (int n = 0; n < 50000 && !HasFailure(); ++n) {
    const Lattice a = point();
    const Lattice b{a.x / 2, a.y / 2};  // on the line through 0, or nearly
    const double at = share(random_);
    const Lattice c{std::llround(at * static_cast<double>(a.x)) + beside(random_),
                    std::llround(at * static_cast<double>(a.y)) + beside(random_)};
    const int scale = exponent();
    expectExact({a, b, c}, scale);
    expectExact({c, a, b}, scale);
  }
}

TEST_P(OrientationOfWholeNumbers, TinyDifferencesFarFromTheOrigin)
{
  std::uniform_int_distribution<std::int64_t> beside(-3, 3);
  for (int n = 0; n < 20000 && !HasFailure(); ++n) {
    const Lattice a = point();
    const auto near = [&] { return Lattice{a.x + beside(random_), a.y + beside(random_)}; };
    const int scale = exponent();
    expectExact({a, near(), near()}, scale);
    expectExact({a, near(), point()}, scale);
  }
}

TEST_P(OrientationOfWholeNumbers, TurnsWithItsPoints)
{
  for (int n = 0; n < 5000; ++n) {
    const int scale = exponent();
    const Eigen::Vector2d a = scaled(point(), scale);
    const Eigen::Vector2d b = scaled(point(), scale);
    const Eigen::Vector2d c = scaled(point(), scale);
    ASSERT_EQ(orientation(a, b, c), orientation(b, c, a));
    ASSERT_EQ(static_cast<int>(orientation(a, b, c)), -static_cast<int>(orientation(b, a, c)));
  }
}

// Up to 2^52, beyond which neighbouring whole numbers are no doubles.
INSTANTIATE_TEST_SUITE_P(Bits, OrientationOfWholeNumbers, testing::Values(3, 12, 26, 40, 51, 52));

}  // namespace
}  // namespace polygonal_perception::geometry

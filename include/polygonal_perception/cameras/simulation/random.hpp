#pragma once

#include <cmath>
#include <cstdint>

namespace polygonal_perception::simulation {

/// A bijection of 64 bits whose outputs look random (splitmix64's finaliser): random numbers by counter, so
/// that any pixel of any frame can be drawn on its own, in any order.
inline std::uint64_t mixBits(std::uint64_t x)
{
  x += 0x9E3779B97F4A7C15ULL;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31);
}

/// A seeded generator. The standard library's distributions give other numbers on other platforms; these do
/// not.
class Random
{
public:
  explicit Random(std::uint64_t seed) : state_(mixBits(seed)) {}
  /// The generator of one of many independent things (a frame, a person) of the same seed.
  Random(std::uint64_t seed, std::uint64_t stream) : state_(mixBits(mixBits(seed) ^ mixBits(~stream))) {}

  std::uint64_t bits() { return mixBits(state_++); }
  /// In [low, high).
  double uniform(double low, double high)
  {
    return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1.0p-53);
  }
  /// In low..high, both included.
  int integer(int low, int high)
  {
    return low + static_cast<int>(bits() % (static_cast<std::uint64_t>(high - low) + 1));
  }
  bool chance(double probability) { return uniform(0.0, 1.0) < probability; }
  /// Either -1 or 1.
  double sign() { return chance(0.5) ? 1.0 : -1.0; }

private:
  std::uint64_t state_;
};

}  // namespace polygonal_perception::simulation

#pragma once

#include <cstdint>

namespace polygonal_perception::perception {

/// Directions along the floor in equal bins, as a LaserScan has them: bin k is centred on first + k increment.
struct BearingBins
{
  double first = 0.0;         ///< [rad] in the floor frame: 0 is ahead, positive to the left
  double increment = 0.0087;  ///< [rad]
  std::uint32_t count = 0;

  double bearing(std::uint32_t bin) const { return first + increment * bin; }
  bool operator==(const BearingBins& other) const
  {
    return first == other.first && increment == other.increment && count == other.count;
  }
};

}  // namespace polygonal_perception::perception

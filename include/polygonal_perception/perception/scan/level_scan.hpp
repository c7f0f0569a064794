#pragma once

#include <vector>

#include "polygonal_perception/perception/grid/bearing_bins.hpp"

namespace polygonal_perception::perception {

/// What a level laser under the camera, on the floor, would see, by REP 117: the distance to the nearest obstacle of each
/// bin; +inf where there is none and the floor was seen up to range_max; NaN where nobody knows.
struct LevelScan
{
  BearingBins bins;
  double range_max = 0.0;     ///< [m]
  std::vector<float> ranges;  ///< [m] along the floor, from the floor frame's origin; one a bin
};

}  // namespace polygonal_perception::perception

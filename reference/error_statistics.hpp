#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "polygonal_perception/geometry/plane.hpp"

namespace polygonal_perception::reference {

/// The angle between two floors' normals [deg].
inline double normalError(const geometry::Plane& found, const geometry::Plane& truth)
{
  constexpr double kDegreesPerRadian = 57.29577951308232;
  return kDegreesPerRadian *
         std::atan2(found.normal.cross(truth.normal).norm(), found.normal.dot(truth.normal));
}

/// The difference of two floors' heights [mm].
inline double heightError(const geometry::Plane& found, const geometry::Plane& truth)
{
  return 1000.0 * std::abs(found.distance - truth.distance);
}

/// What the floor contract calls a wrong plane.
inline bool isWrong(const geometry::Plane& found, const geometry::Plane& truth)
{
  return normalError(found, truth) > 5.0 || heightError(found, truth) > 50.0;
}

/// @param share  0 the least, 0.5 the median, 1 the greatest; of no values at all it is NaN
inline double quantile(std::vector<double> values, double share)
{
  if (values.empty()) return std::nan("");
  std::sort(values.begin(), values.end());
  const auto index = static_cast<std::size_t>(share * static_cast<double>(values.size()));
  return values[std::min(values.size() - 1, index)];
}

}  // namespace polygonal_perception::reference

#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
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

/// An error and the standard deviation that was given for it.
struct ErrorAndSigma
{
  double error = 0.0;
  double sigma = 0.0;
};

/// The errors of a floor's three uncertain quantities: the tilt about the floor frame's x and y axes [rad] and the
/// distance [m].
/// @param covariance  of the normal's three components and the distance
/// @param forward     the camera's viewing direction, from which x comes
inline std::array<ErrorAndSigma, 3> uncertainties(const geometry::Plane& found,
                                                  const Eigen::Matrix4d& covariance,
                                                  const geometry::Plane& truth,
                                                  const Eigen::Vector3d& forward)
{
  const Eigen::Vector3d x = (forward - forward.dot(found.normal) * found.normal).normalized();
  const Eigen::Vector3d y = found.normal.cross(x);
  const Eigen::Vector3d turn = truth.normal.cross(found.normal);
  const Eigen::Matrix3d normal = covariance.topLeftCorner<3, 3>();
  // A small turn w of the normal n changes it by w x n: a turn about x moves it along -y, one about y along x.
  return {{{turn.dot(x), std::sqrt(y.dot(normal * y))},
           {turn.dot(y), std::sqrt(x.dot(normal * x))},
           {found.distance - truth.distance, std::sqrt(covariance(3, 3))}}};
}

}  // namespace polygonal_perception::reference

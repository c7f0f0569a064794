#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "polygonal_perception/geometry/plane.hpp"

namespace polygonal_perception::perception {

/// How much a surface bends that looks like a plane: fits a paraboloid to the heights of its points.
class CurvatureFit
{
public:
  struct Result
  {
    double curvature =
        0.0;             // [1/m] the larger of the two, without its sign: one over the radius of a cylinder
    double sigma = 0.0;  // [1/m] standard deviation of it; neighbouring points err together
  };

  /// @param plane   about which heights are taken
  /// @param centre  [m] of the points
  CurvatureFit(const geometry::Plane& plane, const Eigen::Vector3d& centre);

  void add(const Eigen::Vector3f& point, float weight);

  /// @return no curvature where there are too few points to tell
  Result solve() const;

private:
  static constexpr std::size_t kTerms = 6;  // 1, x, y, x^2, x y, y^2

  Eigen::Vector3f centre_;
  Eigen::Matrix3f axes_;  // rows: x and y on the plane, its normal
  std::array<float, kTerms*(kTerms + 1) / 2>
      sums_{};                               // of weight * term * term, the upper triangle row by row
  std::array<float, kTerms> with_height_{};  // of weight * term * height
  float squares_ = 0.0F;                     // of weight * height^2
  std::size_t count_ = 0;
};

}  // namespace polygonal_perception::perception

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>

#include "polygonal_perception/geometry/plane.hpp"

namespace polygonal_perception::perception {

/// Weighted fit of a plane: collects points, then gives the plane that has the least weighted sum of squared
/// distances from them.
class PlaneFit
{
public:
  /// Neighbouring pixels of a depth image err together: of this many points one counts as independent.
  static constexpr double kPointsPerIndependent = 4.0;

  struct Result
  {
    geometry::Plane plane;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< weighted mean of the points
    double rms_error = 0.0;                            ///< [m] weighted root mean square distance
    /// [rad] how far the normal may be off at most, one standard deviation; neighbouring points err together.
    double normal_sigma = 0.0;
  };

  void add(float x, float y, float z, float weight)
  {
    // Sums are taken about the first point: about the origin the spread of far points would drown in
    // rounding.
    if (count_ == 0) origin_ = {x, y, z};
    const double dx = x - origin_.x();
    const double dy = y - origin_.y();
    const double dz = z - origin_.z();
    const double w = weight;
    weight_ += w;
    x_ += w * dx;
    y_ += w * dy;
    z_ += w * dz;
    xx_ += w * dx * dx;
    xy_ += w * dx * dy;
    xz_ += w * dx * dz;
    yy_ += w * dy * dy;
    yz_ += w * dy * dz;
    zz_ += w * dz * dz;
    ++count_;
  }

  /// Adds all points of another fit.
  void add(const PlaneFit& other);

  std::size_t count() const { return count_; }

  /// By total least squares.
  /// @param up  the plane's normal is turned to this side
  /// @return nothing where the points do not span a plane: fewer than 3, or (nearly) on a line
  std::optional<Result> solve(const Eigen::Vector3d& up) const;

  /// By least squares of the heights over a plane whose normal is known to some extent: points on a line are enough.
  /// @param known  a plane near the points
  /// @param sigma  [rad] standard deviation of its normal about any axis
  std::optional<Result> solveNear(const geometry::Plane& known, double sigma) const;

  /// How uncertain a fit of these points is.
  /// @param sigma  [rad] of the normal that solveNear() was told; none: it was not
  /// @return of the normal's three components [1] and the distance [m]
  Eigen::Matrix4d covariance(const Result& fit, const std::optional<double>& sigma = std::nullopt) const;

private:
  Eigen::Vector3d mean() const { return Eigen::Vector3d(x_, y_, z_) / weight_; }  // from origin_
  Result result(const Eigen::Vector3d& normal, double variance) const;
  /// [m^2] The variance of the mean of the points' heights, if neighbours err together;
  /// @param variance  [m^2] of the heights
  double averaged(double variance) const;
  Eigen::Matrix3d scatter() const;  // about the mean, weighted mean

  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  double weight_ = 0, x_ = 0, y_ = 0, z_ = 0, xx_ = 0, xy_ = 0, xz_ = 0, yy_ = 0, yz_ = 0, zz_ = 0;
  std::size_t count_ = 0;
};

}  // namespace polygonal_perception::perception

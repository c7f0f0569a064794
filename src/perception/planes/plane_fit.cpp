#include "perception/planes/plane_fit.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace polygonal_perception::perception {

namespace {

/// And some of their error is that of all of them: quantisation, a lens, what lies on the floor and nobody tells from
/// it. This share of their distances from the plane does not average out, however many points there are. Without it
/// one floor of fifty would be out of its three standard deviations (doc/floor.md).
constexpr double kSharedError = 0.25;
/// [m] No sensor measures a plane more exactly than this, and a simulated one without noise must not divide by zero.
constexpr double kLeastError = 1e-5;

/// Two axes that span a plane.
Eigen::Matrix<double, 3, 2> axesOf(const Eigen::Vector3d& normal)
{
  Eigen::Matrix<double, 3, 2> axes;
  axes.col(0) = normal.unitOrthogonal();
  axes.col(1) = normal.cross(axes.col(0));
  return axes;
}

}  // namespace

void PlaneFit::add(const PlaneFit& other)
{
  if (other.count_ == 0) return;
  if (count_ == 0) {
    *this = other;
    return;
  }
  const Eigen::Vector3d shift = other.origin_ - origin_;
  const double w = other.weight_;
  const double a = shift.x();
  const double b = shift.y();
  const double c = shift.z();
  xx_ += other.xx_ + 2.0 * a * other.x_ + w * a * a;
  yy_ += other.yy_ + 2.0 * b * other.y_ + w * b * b;
  zz_ += other.zz_ + 2.0 * c * other.z_ + w * c * c;
  xy_ += other.xy_ + a * other.y_ + b * other.x_ + w * a * b;
  xz_ += other.xz_ + a * other.z_ + c * other.x_ + w * a * c;
  yz_ += other.yz_ + b * other.z_ + c * other.y_ + w * b * c;
  x_ += other.x_ + w * a;
  y_ += other.y_ + w * b;
  z_ += other.z_ + w * c;
  weight_ += w;
  count_ += other.count_;
}

Eigen::Matrix3d PlaneFit::scatter() const
{
  Eigen::Matrix3d squares;
  squares << xx_, xy_, xz_, xy_, yy_, yz_, xz_, yz_, zz_;
  return squares / weight_ - mean() * mean().transpose();
}

std::optional<PlaneFit::Result> PlaneFit::solve(const Eigen::Vector3d& up) const
{
  constexpr double kThinnest = 1e-4;  // [m^2] a patch narrower than 1 cm has no plane
  if (count_ < 3 || !(weight_ > 0.0)) return std::nullopt;

  const Eigen::Matrix3d scatter = this->scatter();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  eigen.computeDirect(scatter);
  if (!(eigen.eigenvalues()[1] > kThinnest)) return std::nullopt;

  Eigen::Vector3d normal = eigen.eigenvectors().col(0).normalized();
  if (normal.dot(up) < 0.0) normal = -normal;
  if (!normal.allFinite()) return std::nullopt;
  const double variance = std::max(0.0, normal.dot(scatter * normal));
  Result fit = result(normal, variance);
  fit.normal_sigma = std::sqrt(averaged(variance) / eigen.eigenvalues()[1]);
  return fit;
}

std::optional<PlaneFit::Result> PlaneFit::solveNear(const geometry::Plane& known, double sigma) const
{
  if (count_ < 3 || !(weight_ > 0.0)) return std::nullopt;
  const Eigen::Matrix<double, 3, 2> axes = axesOf(known.normal);
  // height = (normal + axes tilt) . (p - mean): the normal equations, and what is known of the tilt.
  const Eigen::Matrix3d information = weight_ / kPointsPerIndependent * scatter();
  const Eigen::Matrix2d covariance =
      (axes.transpose() * information * axes + Eigen::Matrix2d::Identity() / (sigma * sigma)).inverse();
  const Eigen::Vector2d tilt = -covariance * axes.transpose() * information * known.normal;
  const Eigen::Vector3d normal = (known.normal + axes * tilt).normalized();
  if (!normal.allFinite()) return std::nullopt;
  Result fit = result(normal, std::max(0.0, normal.dot(scatter() * normal)));
  fit.normal_sigma = std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(covariance).eigenvalues()[1]);
  return fit;
}

double PlaneFit::averaged(double variance) const
{
  return kPointsPerIndependent * variance / static_cast<double>(count_);
}

Eigen::Matrix4d PlaneFit::covariance(const Result& fit, const std::optional<double>& sigma) const
{
  const double variance = std::max(fit.rms_error * fit.rms_error, kLeastError * kLeastError);
  const double of_mean = averaged(variance) + kSharedError * kSharedError * variance;
  const Eigen::Matrix<double, 3, 2> axes = axesOf(fit.plane.normal);
  Eigen::Matrix2d information = axes.transpose() * scatter() * axes / of_mean;
  if (sigma) information += Eigen::Matrix2d::Identity() / (*sigma * *sigma);
  const Eigen::Matrix3d normal = axes * information.inverse() * axes.transpose();
  // distance = -normal . centre: a tilt moves it, and so does the error of the mean.
  const Eigen::Vector3d with_distance = -normal * fit.centre;
  Eigen::Matrix4d covariance;
  covariance.topLeftCorner<3, 3>() = normal;
  covariance.topRightCorner<3, 1>() = with_distance;
  covariance.bottomLeftCorner<1, 3>() = with_distance.transpose();
  covariance(3, 3) = of_mean - fit.centre.dot(with_distance);
  return covariance;
}

PlaneFit::Result PlaneFit::result(const Eigen::Vector3d& normal, double variance) const
{
  Result result;
  result.centre = origin_ + mean();
  result.plane = {normal, -normal.dot(result.centre)};
  result.rms_error = std::sqrt(variance);
  return result;
}

}  // namespace polygonal_perception::perception

#include "perception/floor/plane_fit.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace polygonal_perception::perception {

std::optional<PlaneFit::Result> PlaneFit::solve(const Eigen::Vector3d& up) const
{
  // Neighbouring pixels of a depth image err together: of this many points one counts as independent.
  constexpr double kPointsPerIndependent = 4.0;
  constexpr double kThinnest = 1e-4;  // [m^2] a patch narrower than 1 cm has no plane
  if (count_ < 3 || !(weight_ > 0.0)) return std::nullopt;

  const Eigen::Vector3d mean = Eigen::Vector3d(x_, y_, z_) / weight_;
  Eigen::Matrix3d scatter;
  scatter << xx_, xy_, xz_, xy_, yy_, yz_, xz_, yz_, zz_;
  scatter = scatter / weight_ - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  eigen.computeDirect(scatter);
  if (!(eigen.eigenvalues()[1] > kThinnest)) return std::nullopt;

  Result result;
  Eigen::Vector3d normal = eigen.eigenvectors().col(0).normalized();
  if (normal.dot(up) < 0.0) normal = -normal;
  result.centre = origin_ + mean;
  result.plane = {normal, -normal.dot(result.centre)};
  const double variance = std::max(0.0, normal.dot(scatter * normal));
  result.rms_error = std::sqrt(variance);
  result.normal_sigma =
      std::sqrt(kPointsPerIndependent * variance / (static_cast<double>(count_) * eigen.eigenvalues()[1]));
  if (!normal.allFinite()) return std::nullopt;
  return result;
}

}  // namespace polygonal_perception::perception

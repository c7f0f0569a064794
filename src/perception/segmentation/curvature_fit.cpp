#include "perception/segmentation/curvature_fit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "perception/planes/plane_fit.hpp"

namespace polygonal_perception::perception {

CurvatureFit::CurvatureFit(const geometry::Plane& plane, const Eigen::Vector3d& centre)
    : centre_(centre.cast<float>())
{
  const Eigen::Vector3d x = plane.normal.unitOrthogonal();
  axes_ << x.cast<float>().transpose(), plane.normal.cross(x).cast<float>().transpose(),
      plane.normal.cast<float>().transpose();
}

void CurvatureFit::add(const Eigen::Vector3f& point, float weight)
{
  const Eigen::Vector3f p = axes_ * (point - centre_);
  const std::array<float, kTerms> terms = {1.0F, p.x(), p.y(), p.x() * p.x(), p.x() * p.y(), p.y() * p.y()};
  std::size_t at = 0;
  for (std::size_t row = 0; row < kTerms; ++row) {
    const float weighted = weight * terms[row];
    for (std::size_t column = row; column < kTerms; ++column) sums_[at++] += weighted * terms[column];
    with_height_[row] += weighted * p.z();
  }
  squares_ += weight * p.z() * p.z();
  ++count_;
}

CurvatureFit::Result CurvatureFit::solve() const
{
  // Fewer hold no more than the six terms, once neighbours that err together count as one.
  if (static_cast<double>(count_) <= kTerms * PlaneFit::kPointsPerIndependent) return {};
  using Terms = Eigen::Matrix<double, kTerms, 1>;
  Eigen::Matrix<double, kTerms, kTerms> normal;
  Terms right;
  std::size_t at = 0;
  for (std::size_t row = 0; row < kTerms; ++row) {
    for (std::size_t column = row; column < kTerms; ++column)
      normal(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
          normal(static_cast<Eigen::Index>(column), static_cast<Eigen::Index>(row)) = sums_[at++];
    right(static_cast<Eigen::Index>(row)) = with_height_[row];
  }
  const Eigen::LDLT<Eigen::Matrix<double, kTerms, kTerms>> solver(normal);
  const Terms paraboloid = solver.solve(right);
  const double residual = std::max(0.0, squares_ - right.dot(paraboloid)) / static_cast<double>(count_);

  Eigen::Matrix2d second_derivatives;
  second_derivatives << 2.0 * paraboloid(3), paraboloid(4), paraboloid(4), 2.0 * paraboloid(5);
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen;
  eigen.computeDirect(second_derivatives);
  const Eigen::Index larger = std::abs(eigen.eigenvalues()[0]) > std::abs(eigen.eigenvalues()[1]) ? 0 : 1;
  const Eigen::Vector2d along = eigen.eigenvectors().col(larger);
  Terms gradient;
  gradient << 0.0, 0.0, 0.0, 2.0 * along.x() * along.x(), 2.0 * along.x() * along.y(),
      2.0 * along.y() * along.y();
  const double variance = PlaneFit::kPointsPerIndependent * residual * gradient.dot(solver.solve(gradient));
  const Result result{std::abs(eigen.eigenvalues()[larger]), std::sqrt(std::max(0.0, variance))};
  return std::isfinite(result.curvature) && std::isfinite(result.sigma) ? result : Result{};
}

}  // namespace polygonal_perception::perception

#include "polygonal_perception/perception/floor/pinhole_fit.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

namespace polygonal_perception::perception {

namespace {

using Matrix9d = Eigen::Matrix<double, 9, 9>;
using Vector9d = Eigen::Matrix<double, 9, 1>;

/// A pixel and the direction in which its point lies.
struct Ray
{
  Eigen::Vector3d pixel;      // (u, v, 1), u and v from -1 to 1 over the image
  Eigen::Vector3d direction;  // unit
};

std::vector<Ray> raysOf(const SampleGrid& samples, const Eigen::Matrix3d& normalised)
{
  std::vector<Ray> rays;
  for (const Sample& sample : samples.samples()) {
    if (!sample.has_point) continue;
    rays.push_back(
        {normalised * Eigen::Vector3d(sample.u, sample.v, 1.0), sample.point.cast<double>().normalized()});
  }
  return rays;
}

/// The matrix M for which M pixel is parallel to the direction of each ray, up to its length: the direct linear
/// transform. Nothing where more than one matrix would do.
std::optional<Eigen::Matrix3d> fitRays(const std::vector<Ray>& rays)
{
  // Of the second smallest eigenvalue to the number of rays: pixels in a single row have none.
  constexpr double kLeastSpread = 1e-7;
  Matrix9d normal_equations = Matrix9d::Zero();
  for (const Ray& ray : rays) {
    // What M pixel has across the direction: (1 - d d^T) M pixel, a quadratic form in M's columns.
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - ray.direction * ray.direction.transpose();
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j)
        normal_equations.block<3, 3>(3 * i, 3 * j) += ray.pixel[i] * ray.pixel[j] * across;
    }
  }
  const Eigen::SelfAdjointEigenSolver<Matrix9d> solver(normal_equations);
  if (!(solver.eigenvalues()[1] > kLeastSpread * static_cast<double>(rays.size()))) return std::nullopt;
  const Vector9d columns = solver.eigenvectors().col(0);
  Eigen::Matrix3d matrix;
  matrix << columns.segment<3>(0), columns.segment<3>(3), columns.segment<3>(6);
  double ahead = 0.0;
  for (const Ray& ray : rays) ahead += (matrix * ray.pixel).dot(ray.direction);
  return ahead < 0.0 ? Eigen::Matrix3d(-matrix) : matrix;
}

/// [rad] For small angles.
double angleOff(const Eigen::Matrix3d& pinhole, const Ray& ray)
{
  return ((pinhole * ray.pixel).normalized() - ray.direction).norm();
}

/// From pixels to (u, v, 1) with u and v from -1 to 1 over the image, as raysOf() has them.
Eigen::Matrix3d normalisation(const SampleGrid& samples)
{
  double columns = 1.0;
  double rows = 1.0;
  for (const Sample& sample : samples.samples()) {
    columns = std::max(columns, static_cast<double>(sample.u));
    rows = std::max(rows, static_cast<double>(sample.v));
  }
  Eigen::Matrix3d matrix;
  matrix << 2.0 / columns, 0.0, -1.0, 0.0, 2.0 / rows, -1.0, 0.0, 0.0, 1.0;
  return matrix;
}

}  // namespace

std::optional<Pinhole> fitPinhole(const SampleGrid& samples)
{
  const Eigen::Matrix3d normalised = normalisation(samples);
  constexpr std::size_t kFewest = 12;  // rays, for nine unknowns
  constexpr double kPinhole = 0.02;    // [rad] a lens with more distortion, or a lidar, is no pinhole
  std::vector<Ray> rays = raysOf(samples, normalised);
  const std::size_t all = rays.size();
  std::optional<Eigen::Matrix3d> pinhole;
  // Points that do not lie where their pixel looks come from a memory that was not cleared: the second fit is without
  // them.
  for (int round = 0; round < 3; ++round) {
    if (rays.size() < kFewest || 2 * rays.size() < all) return std::nullopt;
    pinhole = fitRays(rays);
    if (!pinhole) return std::nullopt;
    std::vector<double> angles;
    for (const Ray& ray : rays) angles.push_back(angleOff(*pinhole, ray));
    std::nth_element(angles.begin(), angles.begin() + static_cast<std::ptrdiff_t>(angles.size() / 2),
                     angles.end());
    const double limit = std::max(kPinhole, 3.0 * angles[angles.size() / 2]);
    rays.erase(std::remove_if(rays.begin(), rays.end(),
                              [&](const Ray& ray) { return !(angleOff(*pinhole, ray) <= limit); }),
               rays.end());
  }
  const bool fits = std::all_of(rays.begin(), rays.end(),
                                [&](const Ray& ray) { return angleOff(*pinhole, ray) <= kPinhole; });
  if (!fits) return std::nullopt;

  Pinhole fit;
  fit.direction_of_pixel = *pinhole * normalised;
  fit.centre = pinhole->col(2).normalized();
  return fit;
}

}  // namespace polygonal_perception::perception

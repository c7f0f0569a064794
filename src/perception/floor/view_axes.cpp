#include "polygonal_perception/perception/floor/view_axes.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
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

std::vector<Ray> raysOf(const SampleGrid& samples)
{
  double columns = 1.0;
  double rows = 1.0;
  for (const Sample& sample : samples.samples()) {
    columns = std::max(columns, static_cast<double>(sample.u));
    rows = std::max(rows, static_cast<double>(sample.v));
  }
  std::vector<Ray> rays;
  for (const Sample& sample : samples.samples()) {
    if (!sample.has_point) continue;
    rays.push_back({{2.0 * sample.u / columns - 1.0, 2.0 * sample.v / rows - 1.0, 1.0},
                    sample.point.cast<double>().normalized()});
  }
  return rays;
}

/// The matrix M for which M pixel is parallel to the direction of each ray, up to its length: the direct linear
/// transform. Nothing where more than one matrix would do.
std::optional<Eigen::Matrix3d> fitPinhole(const std::vector<Ray>& rays)
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

/// The frame's own axis where one is this near, so that rounding moves nothing.
Eigen::Vector3d snapped(const Eigen::Vector3d& direction)
{
  constexpr double kSame = 0.999994;  // cosine of 0.2 degrees
  Eigen::Index largest = 0;
  const double along = direction.cwiseAbs().maxCoeff(&largest);
  if (along < kSame) return direction;
  return std::copysign(1.0, direction[largest]) * Eigen::Vector3d::Unit(largest);
}

}  // namespace

std::optional<ViewAxes> viewAxesOfPixels(const SampleGrid& samples)
{
  constexpr std::size_t kFewest = 12;  // rays, for nine unknowns
  constexpr double kPinhole = 0.02;    // [rad] a lens with more distortion, or a lidar, is no pinhole
  std::vector<Ray> rays = raysOf(samples);
  const std::size_t all = rays.size();
  std::optional<Eigen::Matrix3d> pinhole;
  // Points that do not lie where their pixel looks come from a memory that was not cleared: the second fit is without
  // them.
  for (int round = 0; round < 3; ++round) {
    if (rays.size() < kFewest || 2 * rays.size() < all) return std::nullopt;
    pinhole = fitPinhole(rays);
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

  // Rows and columns of the image run along the first two columns, and the viewing direction is across both.
  const Eigen::Vector3d down = pinhole->col(1).normalized();
  Eigen::Vector3d forward = pinhole->col(0).cross(down).normalized();
  if (forward.dot(pinhole->col(2)) < 0.0) forward = -forward;  // a mirrored image
  ViewAxes axes;
  axes.forward = snapped(forward);
  axes.upward = snapped((axes.forward.dot(down) * axes.forward - down).normalized());
  axes.upward = (axes.upward - axes.forward.dot(axes.upward) * axes.forward).normalized();
  axes.source = ViewAxes::Source::kPixels;
  return axes;
}

ViewAxes conventionalViewAxes(PointLayout layout, const Eigen::Vector3d& initial_up)
{
  constexpr double kBody =
      0.7;  // cosine of 45 degrees: z of a body frame is up, that of an optical one is not
  if (layout != PointLayout::kCloud || initial_up.normalized().z() < kBody) return {};
  return {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ(), ViewAxes::Source::kBodyFrame};
}

ViewAxes viewAxesAlong(const Eigen::Vector3d& forward, const Eigen::Vector3d& initial_up)
{
  const Eigen::Vector3d ahead = forward.normalized();
  const Eigen::Vector3d up = initial_up.normalized();
  const Eigen::Vector3d upward = up - up.dot(ahead) * ahead;
  constexpr double kAcross = 0.01;  // a direction that is up itself has any other for its upper border
  return {ahead, upward.norm() > kAcross ? upward.normalized() : ahead.unitOrthogonal(),
          ViewAxes::Source::kParameter};
}

}  // namespace polygonal_perception::perception

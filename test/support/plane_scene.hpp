#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "polygonal_perception/geometry/plane.hpp"
#include "polygonal_perception/perception/input/point_view.hpp"

namespace polygonal_perception::test {

/// A depth image of a few pieces of planes, worked out pixel by pixel: for tests whose truth is in sight.
class PlaneScene
{
public:
  using Inside = std::function<bool(const Eigen::Vector3d&)>;

  /// @param sigma  [m] of white noise on the depth
  explicit PlaneScene(std::uint32_t width = 160, std::uint32_t height = 120, double focal_length = 142.5,
                      double sigma = 0.0)
      : rays_(perception::PinholeRays::make(width, height, focal_length, focal_length, 0.5 * (width - 1),
                                            0.5 * (height - 1))),
        depth_(static_cast<std::size_t>(width) * height, std::numeric_limits<float>::quiet_NaN()),
        noise_(0.0, sigma)
  {
  }

  /// Adds the part of a plane for which `inside` holds, in the optical frame; the nearest surface is seen.
  void add(
      const geometry::Plane& plane, const Inside& inside = [](const Eigen::Vector3d&) { return true; })
  {
    const std::size_t width = rays_.column_slope.size();
    for (std::size_t k = 0; k < depth_.size(); ++k) {
      const Eigen::Vector3d ray(rays_.column_slope[k % width], rays_.row_slope[k / width], 1.0);
      const double z = -plane.distance / plane.normal.dot(ray);
      if (!(z > 0.0 && z < kFarthest) || depth_[k] <= z || !inside(z * ray)) continue;
      depth_[k] = static_cast<float>(z + (noise_.stddev() > 0.0 ? noise_(random_) : 0.0));
    }
  }

  perception::PointView view() const
  {
    return perception::PointView::depth(depth_.data(), rays_.column_slope.size() * sizeof(float), rays_);
  }

  std::vector<float>& depth() { return depth_; }

private:
  static constexpr double kFarthest = 8.0;  // [m]

  perception::PinholeRays rays_;
  std::vector<float> depth_;
  std::mt19937 random_{1};
  std::normal_distribution<double> noise_;
};

/// The floor in the optical frame of a camera at a height [m], pitched down and rolled [rad].
inline geometry::Plane floorSeenFrom(double height, double pitch, double roll = 0.0)
{
  return {
      Eigen::Vector3d(std::sin(roll) * std::cos(pitch), -std::cos(roll) * std::cos(pitch), -std::sin(pitch)),
      height};
}

/// The plane that lies `offset` [m] above another one.
inline geometry::Plane raised(const geometry::Plane& plane, double offset)
{
  return {plane.normal, plane.distance - offset};
}

}  // namespace polygonal_perception::test

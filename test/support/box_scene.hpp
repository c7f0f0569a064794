#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "polygonal_perception/perception/floor/floor_frame.hpp"
#include "polygonal_perception/perception/input/point_view.hpp"

namespace polygonal_perception::test {

/// What a camera sees of boxes on a level floor, without noise. In the floor frame: x ahead, y left, z up.
struct BoxScene
{
  std::vector<Eigen::AlignedBox3d> boxes;
  geometry::Plane floor{{0.0, -std::cos(0.35), -std::sin(0.35)}, 0.8};  ///< in the camera's optical frame
  std::uint32_t width = 320;
  std::uint32_t height = 240;

  perception::PinholeRays rays() const
  {
    const double focal_length = 0.9 * width;
    return perception::PinholeRays::make(width, height, focal_length, focal_length, 0.5 * (width - 1.0),
                                         0.5 * (height - 1.0));
  }

  Eigen::Isometry3d toFloorFrame() const { return perception::floorFrame(floor, perception::ViewAxes{}); }

  /// [m] NaN where the ray of a pixel meets nothing within 8 m.
  std::vector<float> depth() const
  {
    const perception::PinholeRays r = rays();
    const Eigen::Isometry3d to_floor = toFloorFrame();
    const Eigen::AlignedBox3d ground(Eigen::Vector3d(-100.0, -100.0, -1.0),
                                     Eigen::Vector3d(100.0, 100.0, 0.0));
    std::vector<float> image;
    image.reserve(std::size_t{width} * height);
    for (const float slope_v : r.row_slope) {
      for (const float slope_u : r.column_slope) {
        const Eigen::Vector3d ray = to_floor.linear() * Eigen::Vector3d(slope_u, slope_v, 1.0);
        double nearest = along(ground, to_floor.translation(), ray);
        for (const auto& box : boxes) nearest = std::min(nearest, along(box, to_floor.translation(), ray));
        image.push_back(nearest < 8.0 ? static_cast<float>(nearest)
                                      : std::numeric_limits<float>::quiet_NaN());
      }
    }
    return image;
  }

private:
  /// How many times `ray` it is from `origin` to a box.
  static double along(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& origin,
                      const Eigen::Vector3d& ray)
  {
    const Eigen::Array3d a = (box.min() - origin).array() / ray.array();
    const Eigen::Array3d b = (box.max() - origin).array() / ray.array();
    const double enter = a.min(b).maxCoeff();
    const double leave = a.max(b).minCoeff();
    return enter > 0.0 && enter <= leave ? enter : std::numeric_limits<double>::infinity();
  }
};

}  // namespace polygonal_perception::test

#include "polygonal_perception/projection.hpp"

#include <cmath>

namespace polygonal_perception {

void Projection::project(const PointView& points, const Eigen::Isometry3d& to_floor_frame, BinaryGrid& occupancy)
{
  const GridGeometry geometry = occupancy.geometry();
  occupancy.reset(geometry);
  counts_.assign(geometry.size(), 0);

  const Eigen::Isometry3f transform = to_floor_frame.cast<float>();
  const auto cells_per_metre = static_cast<float>(1.0 / geometry.resolution);
  const auto lowest = static_cast<float>(parameters_.min_height);
  const auto highest = static_cast<float>(parameters_.max_height);
  for (std::uint32_t v = 0; v < points.height(); ++v) {
    for (std::uint32_t u = 0; u < points.width(); ++u) {
      const Eigen::Vector3f p = transform * points.point(u, v);
      // Written so that NaN fails.
      if (!(p.z() >= lowest && p.z() <= highest)) continue;
      const float x = (p.x() - static_cast<float>(geometry.origin_x)) * cells_per_metre;
      const float y = (p.y() - static_cast<float>(geometry.origin_y)) * cells_per_metre;
      if (!(x >= 0.0F && x < geometry.cells_x && y >= 0.0F && y < geometry.cells_y)) continue;
      const auto cell = static_cast<std::size_t>(y) * geometry.cells_x + static_cast<std::size_t>(x);
      if (counts_[cell] < parameters_.min_points_per_cell) ++counts_[cell];
    }
  }
  for (int j = 0; j < geometry.cells_y; ++j) {
    for (int i = 0; i < geometry.cells_x; ++i) {
      const auto cell = static_cast<std::size_t>(j) * geometry.cells_x + static_cast<std::size_t>(i);
      occupancy.set(i, j, counts_[cell] >= parameters_.min_points_per_cell);
    }
  }
}

}  // namespace polygonal_perception

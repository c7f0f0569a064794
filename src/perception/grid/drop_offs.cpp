#include "polygonal_perception/perception/grid/drop_offs.hpp"

namespace polygonal_perception::perception {

void DropOffs::mark(const PointView& points, const Eigen::Isometry3d& to_floor_frame,
                    occupancy::BinaryGrid& occupancy, const GroundMap* ground) const
{
  // A floor's normal may be off by half a degree: so much further down, for each metre, a point must be.
  constexpr float kPerMetre = 0.01F;
  constexpr std::uint32_t kStep = 4;
  if (!(parameters_.drop_height > 0.0)) return;

  const Eigen::Isometry3f transform = to_floor_frame.cast<float>();
  const Eigen::Vector3f camera = transform.translation();
  const occupancy::GridGeometry& geometry = occupancy.geometry();
  const auto drop = static_cast<float>(parameters_.drop_height);
  for (std::uint32_t v = kStep / 2; v < points.height(); v += kStep) {
    for (std::uint32_t u = kStep / 2; u < points.width(); u += kStep) {
      const Eigen::Vector3f ray = transform.linear() * points.point(u, v);
      const Eigen::Vector3f point = camera + ray;
      float depth_below = -point.z();
      if (ground != nullptr && point.allFinite()) depth_below += ground->at(point.x(), point.y()).higher;
      // Written so that NaN and infinity fail.
      if (!(depth_below > drop + kPerMetre * ray.norm() && depth_below < 1e3F)) continue;
      const Eigen::Vector3f crossing = camera + ray * (-camera.z() / ray.z());
      const auto cell = geometry.cellOf(crossing.x(), crossing.y());
      if (cell) occupancy.row(0)[*cell] = 1;
    }
  }
}

}  // namespace polygonal_perception::perception

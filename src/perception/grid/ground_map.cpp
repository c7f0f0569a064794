#include "polygonal_perception/perception/grid/ground_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polygonal_perception::perception {

namespace {

constexpr float kFar = 1e6F;  // [m]

}  // namespace

void GroundSurface::setPlane(const geometry::Plane& plane, const Eigen::Isometry3d& to_floor_frame)
{
  const Eigen::Vector3d normal = to_floor_frame.linear() * plane.normal;
  const double distance = plane.distance - normal.dot(to_floor_frame.translation());
  slope = (-normal.head<2>() / normal.z()).cast<float>();
  offset = static_cast<float>(-distance / normal.z());
}

void GroundMap::build(const occupancy::GridGeometry& geometry, const std::vector<GroundSurface>& surfaces)
{
  geometry_ = geometry;
  surfaces_ = surfaces;
  surfaces_of_.assign(geometry.size(), {0, 0});
  nearest_.assign(geometry.size(), kFar);
  second_.assign(geometry.size(), kFar);
  for (std::size_t s = 0; s < surfaces_.size(); ++s) {
    findDistances(surfaces_[s]);
    const auto number = static_cast<std::uint8_t>(s);
    for (std::size_t cell = 0; cell < geometry.size(); ++cell) {
      auto& [first, second] = surfaces_of_[cell];
      const float distance = distances_[cell];
      if (distance < nearest_[cell]) {
        second_[cell] = nearest_[cell];
        second = first;
        nearest_[cell] = distance;
        first = number;
      } else if (distance < second_[cell]) {
        second_[cell] = distance;
        second = number;
      }
    }
  }
  lowest_ = std::numeric_limits<float>::infinity();
  highest_ = -lowest_;
  for (std::size_t cell = 0; cell < geometry.size(); ++cell) {
    auto& [first, second] = surfaces_of_[cell];
    if (second_[cell] > nearest_[cell] + kBlend) second = first;
    const auto column = static_cast<double>(cell % static_cast<std::size_t>(geometry.cells_x));
    const auto row = static_cast<double>(cell / static_cast<std::size_t>(geometry.cells_x));
    for (const double corner : {0.0, 1.0}) {
      const auto x = static_cast<float>(geometry.origin_x + (column + corner) * geometry.resolution);
      const auto y = static_cast<float>(geometry.origin_y + (row + corner) * geometry.resolution);
      // A slope across the corners that are not looked at is within a cell of those that are.
      const Span ground = at(x, y);
      const auto across = static_cast<float>(geometry.resolution) *
                          std::max(surfaces_[first].slope.norm(), surfaces_[second].slope.norm());
      lowest_ = std::min(lowest_, ground.lower - across);
      highest_ = std::max(highest_, ground.higher + across);
    }
  }
}

std::size_t GroundMap::cellOf(float x, float y) const
{
  const auto index = [](double along, int cells) {
    return static_cast<std::size_t>(std::clamp(along, 0.0, cells - 1.0));
  };
  const std::size_t i = index((x - geometry_.origin_x) / geometry_.resolution, geometry_.cells_x);
  const std::size_t j = index((y - geometry_.origin_y) / geometry_.resolution, geometry_.cells_y);
  return j * static_cast<std::size_t>(geometry_.cells_x) + i;
}

/// The chamfer distance: two passes over the grid, right to 8 percent.
void GroundMap::findDistances(const GroundSurface& surface)
{
  distances_.assign(geometry_.size(), kFar);
  for (const Eigen::Vector2f& sample : surface.samples) distances_[cellOf(sample.x(), sample.y())] = 0.0F;
  const auto straight = static_cast<float>(geometry_.resolution);
  const float diagonal = straight * std::sqrt(2.0F);
  const int columns = geometry_.cells_x;
  const int rows = geometry_.cells_y;
  const auto relax = [&](int i, int j, int di, int dj, float step) {
    const int from_i = i + di;
    const int from_j = j + dj;
    if (from_i < 0 || from_i >= columns || from_j < 0 || from_j >= rows) return;
    float& here = distances_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) +
                             static_cast<std::size_t>(i)];
    here = std::min(here,
                    step + distances_[static_cast<std::size_t>(from_j) * static_cast<std::size_t>(columns) +
                                      static_cast<std::size_t>(from_i)]);
  };
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      relax(i, j, -1, 0, straight);
      relax(i, j, 0, -1, straight);
      relax(i, j, -1, -1, diagonal);
      relax(i, j, 1, -1, diagonal);
    }
  }
  for (int j = rows - 1; j >= 0; --j) {
    for (int i = columns - 1; i >= 0; --i) {
      relax(i, j, 1, 0, straight);
      relax(i, j, 0, 1, straight);
      relax(i, j, 1, 1, diagonal);
      relax(i, j, -1, 1, diagonal);
    }
  }
}

}  // namespace polygonal_perception::perception

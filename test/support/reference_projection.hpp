#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <vector>

#include "polygonal_perception/occupancy/grid/binary_grid.hpp"
#include "polygonal_perception/perception/grid/projection.hpp"
#include "polygonal_perception/perception/input/point_view.hpp"

namespace polygonal_perception::test {

/// The projection as plainly as it can be written, pixel by pixel in scalar code, with the operations in the
/// order that projection_kernel.hpp states. The kernels have to find the very same cells.
class ReferenceProjection
{
public:
  ReferenceProjection(const perception::Projection::Parameters& parameters,
                      const Eigen::Isometry3d& to_floor_frame, const occupancy::GridGeometry& geometry)
      : geometry_(geometry), enough_(parameters.min_points_per_cell)
  {
    const double scale = 1.0 / geometry.resolution;
    height_ = to_floor_frame.linear().row(2).transpose().cast<float>();
    column_ = (scale * to_floor_frame.linear().row(0).transpose()).cast<float>();
    row_ = (scale * to_floor_frame.linear().row(1).transpose()).cast<float>();
    column_offset_ = static_cast<float>((to_floor_frame.translation().x() - geometry.origin_x) * scale);
    row_offset_ = static_cast<float>((to_floor_frame.translation().y() - geometry.origin_y) * scale);
    lowest_ = static_cast<float>(parameters.min_height - to_floor_frame.translation().z());
    highest_ = static_cast<float>(parameters.max_height - to_floor_frame.translation().z());
    const double below = parameters.min_height + std::abs(parameters.min_height);
    lowest_floor_ = lowest_ - static_cast<float>(below);
    slabs_per_metre_ = static_cast<float>(1.0 / parameters.slabHeight());
  }

  /// Where the point of a pixel lies.
  struct Place
  {
    std::size_t cell = 0;  // its row-major index
    int slab = 0;          // -1: it is of the floor
  };

  /// The row-major index of the cell in which the point of a pixel stands.
  std::optional<std::size_t> cell(const perception::PointView& points, std::uint32_t u, std::uint32_t v) const
  {
    const std::optional<Place> place = this->place(points, u, v);
    if (!place || place->slab < 0) return std::nullopt;
    return place->cell;
  }

  /// The same with the floor's points.
  std::optional<Place> place(const perception::PointView& points, std::uint32_t u, std::uint32_t v) const
  {
    if (points.layout() == perception::PointLayout::kCloud) {
      const Eigen::Vector3f p = points.point(u, v);
      if (!isWithin(points, dot(p, p))) return std::nullopt;
      return place(dot(height_, p), dot(column_, p) + column_offset_, dot(row_, p) + row_offset_);
    }
    const bool metres = points.layout() == perception::PointLayout::kDepthMetres;
    const float unit = points.unit();
    const float z =
        metres ? read<float>(points, u, v) : static_cast<float>(read<std::uint16_t>(points, u, v));
    const float none = metres ? std::numeric_limits<float>::infinity() : 65535.0F;
    if (!(z > 0.0F && z < none)) return std::nullopt;
    const float column_slope = unit * points.rays()->column_slope[u];
    const float row_slope = points.rays()->row_slope[v];
    const float square = unit * unit * (row_slope * row_slope + 1.0F);
    if (!isWithin(points, z * z * (column_slope * column_slope + square))) return std::nullopt;
    const auto along = [&](const Eigen::Vector3f& a) {
      return z * (a.x() * column_slope + unit * (a.y() * row_slope + a.z()));
    };
    return place(along(height_), along(column_) + column_offset_, along(row_) + row_offset_);
  }

  occupancy::BinaryGrid project(const perception::PointView& points) const
  {
    std::vector<int> counts(geometry_.size(), 0);
    for (std::uint32_t v = 0; v < points.height(); ++v) {
      for (std::uint32_t u = 0; u < points.width(); ++u) {
        if (const auto standing_in = cell(points, u, v)) ++counts[*standing_in];
      }
    }
    occupancy::BinaryGrid grid(geometry_);
    for (std::size_t k = 0; k < counts.size(); ++k) grid.row(0)[k] = counts[k] >= enough_ ? 1 : 0;
    return grid;
  }

private:
  static bool isWithin(const perception::PointView& points, float squared)
  {
    return squared >= points.nearestSquared() && squared <= points.farthestSquared();
  }

  static float dot(const Eigen::Vector3f& a, const Eigen::Vector3f& p)
  {
    return a.x() * p.x() + a.y() * p.y() + a.z() * p.z();
  }

  template <class T>
  static T read(const perception::PointView& points, std::uint32_t u, std::uint32_t v)
  {
    T value;
    std::memcpy(&value, points.row(v) + u * sizeof value, sizeof value);
    return value;
  }

  std::optional<Place> place(float height, float column, float row) const
  {
    if (!(height >= lowest_floor_ && height <= highest_)) return std::nullopt;
    if (!(column >= 0.0F && column < static_cast<float>(geometry_.cells_x))) return std::nullopt;
    if (!(row >= 0.0F && row < static_cast<float>(geometry_.cells_y))) return std::nullopt;
    const std::size_t cell = static_cast<std::size_t>(row) * static_cast<std::size_t>(geometry_.cells_x) +
                             static_cast<std::size_t>(column);
    if (height < lowest_) return Place{cell, -1};
    const auto slab = static_cast<int>((height - lowest_) * slabs_per_metre_);
    return Place{cell, std::min(slab, occupancy::ObservedCells::kSlabs - 1)};
  }

  occupancy::GridGeometry geometry_;
  int enough_;
  Eigen::Vector3f height_, column_, row_;
  float column_offset_, row_offset_;
  float lowest_, highest_;
  float lowest_floor_, slabs_per_metre_;
};

}  // namespace polygonal_perception::test

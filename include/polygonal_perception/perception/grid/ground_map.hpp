#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/plane.hpp"
#include "polygonal_perception/occupancy/grid/binary_grid.hpp"

namespace polygonal_perception::perception {

/// A plane of the ground in the floor frame, z = slope . (x, y) + offset, and where it was seen.
struct GroundSurface
{
  Eigen::Vector2f slope = Eigen::Vector2f::Zero();
  float offset = 0.0F;                   ///< [m]
  std::vector<Eigen::Vector2f> samples;  ///< [m]

  /// @param plane           in the input's frame, not upright
  /// @param to_floor_frame  from there
  void setPlane(const geometry::Plane& plane, const Eigen::Isometry3d& to_floor_frame);

  float at(float x, float y) const { return slope.x() * x + slope.y() * y + offset; }
};

/// How high the ground lies in each cell of a grid: on the plane that was seen nearest to it, and between two of them on
/// the higher one, so that ground never becomes an obstacle.
class POLYGONAL_PERCEPTION_EXPORT GroundMap
{
public:
  /// [m] A second plane counts in a cell, too, where it was seen so little farther away than the nearest.
  static constexpr float kBlend = 0.3F;

  /// Makes the map anew. Allocates only when the grid or the number of surfaces grows.
  /// @param surfaces  the floor, and others with a sample each; a floor without samples is nowhere the nearest
  void build(const occupancy::GridGeometry& geometry, const std::vector<GroundSurface>& surfaces);

  /// [m] Farther than this from where it was seen nobody knows whether a ramp goes on: what stands there is looked for
  /// above the lower and up to the higher one of the ramp and the floor.
  static constexpr float kSeen = 0.8F;

  /// [m] Between which heights the ground lies; one, where it was seen.
  struct Span
  {
    float lower;
    float higher;
  };

  /// Under a point of the floor frame. Outside of the grid what its nearest cell has counts.
  Span at(float x, float y) const
  {
    const std::size_t cell = cellOf(x, y);
    const auto& [first, second] = surfaces_of_[cell];
    const float height = std::max(surfaces_[first].at(x, y), surfaces_[second].at(x, y));
    if (nearest_[cell] <= kSeen) return {height, height};
    const float floor = surfaces_.front().at(x, y);
    return {std::min(height, floor), std::max(height, floor)};
  }

  /// [m] Between what heights all ground of the grid lies.
  float lowest() const { return lowest_; }
  float highest() const { return highest_; }

private:
  std::size_t cellOf(float x, float y) const;
  void findDistances(const GroundSurface& surface);

  occupancy::GridGeometry geometry_;
  std::vector<GroundSurface> surfaces_;
  std::vector<std::array<std::uint8_t, 2>>
      surfaces_of_;               // of each cell: the nearest, and another or the same
  std::vector<float> distances_;  // [m] of each cell to the samples of a surface
  std::vector<float> nearest_;
  std::vector<float> second_;
  float lowest_ = 0.0F;
  float highest_ = 0.0F;
};

}  // namespace polygonal_perception::perception

#pragma once

#include <Eigen/Geometry>
#include <cstdint>

#include "polygonal_perception/occupancy/grid/binary_grid.hpp"

namespace polygonal_perception::mapping {

/// What one frame of a sensor shows, cell by cell, and where its grid lies. It owns nothing.
struct Observation
{
  const occupancy::GridGeometry& geometry;  ///< in the frame of the grid
  /// Of the frame of the grid in the map's: a place p of the grid is pose * p there.
  const Eigen::Isometry2d& pose;
  // A number a cell each, row-major, as in occupancy::ObservedCells.
  const std::uint8_t* hit;    ///< bit k: a point stands in the slab k of heights
  const std::uint8_t* free;   ///< bit k: the sensor looked through the slab k
  const std::uint8_t* floor;  ///< 1: the floor itself was seen
  /// Whether the frame may take away what it does not see any more: its own floor was found, and it is not late.
  bool may_clear;
  double stamp;  ///< [s]
};

}  // namespace polygonal_perception::mapping

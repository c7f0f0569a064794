#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "polygonal_perception/occupancy/grid/binary_grid.hpp"
#include "polygonal_perception/occupancy/grid/observed_cells.hpp"

namespace polygonal_perception::reference {

/// What one frame of a drive shows a map.
struct ObservedFrame
{
  occupancy::GridGeometry geometry;
  occupancy::ObservedCells cells;
  Eigen::Isometry2d pose;  ///< of the floor frame in the world
  Eigen::Vector2d robot;
};

/// A round of some 30 s through an office in which somebody walks about, three frames a second.
std::vector<ObservedFrame> observedDrive();

}  // namespace polygonal_perception::reference

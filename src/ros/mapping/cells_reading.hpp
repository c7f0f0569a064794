#pragma once

#include <polygonal_perception/ObservedCells.h>

#include <Eigen/Geometry>
#include <string>

#include "polygonal_perception/occupancy/grid/binary_grid.hpp"

namespace polygonal_perception::ros_mapping {

/// Where the cells of a message lie.
struct CellsPlace
{
  occupancy::GridGeometry geometry;  ///< its origin is (0, 0)
  Eigen::Isometry2d pose;            ///< of that origin in the message's frame
};
CellsPlace placeOf(const ObservedCells& cells);

/// Checks what anybody may have sent.
///
/// @return what is wrong, with the field, what it is and what is accepted; empty where nothing is
std::string cellsError(const ObservedCells& cells);

}  // namespace polygonal_perception::ros_mapping

#pragma once

#include <nav_msgs/MapMetaData.h>
#include <nav_msgs/OccupancyGrid.h>
#include <std_msgs/Header.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/occupancy/grid/binary_grid.hpp"

/// Grids as messages, each a new one that nobody touches any more: readers in the same process share it.
namespace polygonal_perception::ros_common {

/// @param output_pose  of the grid's frame in the output frame
POLYGONAL_PERCEPTION_EXPORT nav_msgs::MapMetaData toMetaData(const ros::Time& stamp,
                                                             const occupancy::GridGeometry& geometry,
                                                             const Eigen::Isometry2d& output_pose);

/// Occupied cells are 100, free ones 0.
///
/// @param header       stamp of the input, output frame
/// @param output_pose  of the grid's frame in the output frame
POLYGONAL_PERCEPTION_EXPORT nav_msgs::OccupancyGridPtr toOccupancyGrid(const std_msgs::Header& header,
                                                                       const occupancy::BinaryGrid& grid,
                                                                       const Eigen::Isometry2d& output_pose);

/// Occupied cells are 100, those in which the floor itself was seen 0, the others -1.
///
/// @param floor  in the order of the grid: not 0 where the floor was seen
POLYGONAL_PERCEPTION_EXPORT nav_msgs::OccupancyGridPtr toObservedGrid(const std_msgs::Header& header,
                                                                      const occupancy::BinaryGrid& occupancy,
                                                                      const std::vector<std::uint8_t>& floor,
                                                                      const Eigen::Isometry2d& output_pose);

/// Every cell is unknown, -1: the grid where there is no floor.
POLYGONAL_PERCEPTION_EXPORT nav_msgs::OccupancyGridPtr toUnknownGrid(const std_msgs::Header& header,
                                                                     const occupancy::GridGeometry& geometry,
                                                                     const Eigen::Isometry2d& output_pose);

}  // namespace polygonal_perception::ros_common

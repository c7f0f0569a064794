#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <pcl_msgs/ModelCoefficients.h>
#include <polygonal_perception/FloorPlane.h>
#include <polygonal_perception/ObservedCells.h>
#include <polygonal_perception/PlaneArray.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/Header.h>

#include <Eigen/Geometry>
#include <vector>

#include "polygonal_perception/occupancy/grid/binary_grid.hpp"
#include "polygonal_perception/occupancy/grid/observed_cells.hpp"
#include "polygonal_perception/perception/floor/floor_frame.hpp"
#include "polygonal_perception/perception/floor/floor_tracker.hpp"
#include "polygonal_perception/perception/scan/level_scan.hpp"
#include "polygonal_perception/perception/segmentation/segmented_planes.hpp"

/// The results of a frame as messages. Every function makes a new message that nobody touches any more:
/// readers in the same process share it.
namespace polygonal_perception::ros_perception {

/// @param header  stamp and frame of the input
/// @param hull    convex hull of the floor samples, on the plane, in the input's frame
FloorPlanePtr toFloorPlane(const std_msgs::Header& header, const perception::FloorState& floor,
                           const Eigen::Isometry3d& to_floor_frame, const std::vector<Eigen::Vector3f>& hull);

/// a, b, c, d of the plane a x + b y + c z + d = 0; no values where there is no floor.
pcl_msgs::ModelCoefficientsPtr toModelCoefficients(const std_msgs::Header& header,
                                                   const perception::FloorState& floor);

/// @param header  stamp and frame of the input
PlaneArrayPtr toPlaneArray(const std_msgs::Header& header, const perception::SegmentedPlanes& planes);

/// What is observed, by height; all 0 without a floor. A cell that is occupied by a drop has the lowest slab hit.
///
/// @param occupancy, observed  of one frame; the occupancy has its geometry also where nothing is observed
/// @param slab_height          [m]
ObservedCellsPtr toObservedCells(const std_msgs::Header& header, const perception::FloorState& floor,
                                 const occupancy::BinaryGrid& occupancy,
                                 const occupancy::ObservedCells& observed, double slab_height,
                                 const Eigen::Isometry2d& output_pose);

/// All rays of a scan are of one moment: the input's stamp.
///
/// @param header  stamp of the input, floor frame
sensor_msgs::LaserScanPtr toLaserScan(const std_msgs::Header& header, const perception::LevelScan& scan);

}  // namespace polygonal_perception::ros_perception

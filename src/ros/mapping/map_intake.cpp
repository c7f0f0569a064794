#include "ros/mapping/map_intake.hpp"

#include <polygonal_perception/FloorPlane.h>

#include <algorithm>
#include <cmath>

#include "polygonal_perception/parameters/parameter_check.hpp"
#include "ros/mapping/cells_reading.hpp"

namespace polygonal_perception::ros_mapping {

using parameters::numberText;

namespace {

/// What turns about z and shifts in the plane; the rest is a matter of the floor.
Eigen::Isometry2d inPlane(const Eigen::Isometry3d& transform)
{
  const Eigen::Matrix3d r = transform.linear();
  const double yaw = std::atan2(r(1, 0) - r(0, 1), r(0, 0) + r(1, 1));
  return Eigen::Translation2d(transform.translation().head<2>()) * Eigen::Rotation2Dd(yaw);
}

}  // namespace

MapIntake::MapIntake(const mapping::PolygonMap::Parameters& parameters,
                     const std::vector<std::string>& sources)
    : sources_(sources), map_(parameters)
{
}

MapIntake::Admission MapIntake::admit(std::size_t source, const ObservedCells& cells)
{
  Admission admission;
  if (const std::string error = cellsError(cells); !error.empty()) {
    admission.fault = "cells";
    admission.reason = sources_.name(source) + ": " + error;
    return admission;
  }
  admission.time_jumped_back = sources_.jumpsBack(source, cells.header.stamp);
  if (admission.time_jumped_back) clear();
  constexpr float kSame = 1e-4F;  // [m]
  if (slab_height_ > 0.0F && std::abs(cells.slab_height - slab_height_) > kSame) {
    admission.fault = "slabs";
    admission.reason = sources_.name(source) + ": slab_height is " + numberText(cells.slab_height) +
                       " and in the map " + numberText(slab_height_) +
                       ", accepted are sensors with the same min_height and max_height (~clear begins anew)";
  }
  return admission;
}

bool MapIntake::Placement::isNear() const
{
  constexpr double kFarthest = 1e6;  // [m]
  return robot_to_fixed.translation().norm() <= kFarthest &&
         (!grid_to_fixed || grid_to_fixed->translation().norm() <= kFarthest);
}

void MapIntake::take(std::size_t source, const ObservedCells& cells, const Placement& placement,
                     double max_delay)
{
  const bool may_clear =
      sources_.mayClear(source, cells.header.stamp, cells.floor_status, max_delay, MapSources::Clock::now());
  newest_ = std::max(newest_, cells.header.stamp);
  if (cells.floor_status == FloorPlane::FOUND) sources_.setFloor(source, placement.grid_to_fixed);
  slab_height_ = cells.slab_height;

  const CellsPlace in_message = placeOf(cells);
  const Eigen::Isometry2d pose =
      placement.grid_to_fixed ? inPlane(*placement.grid_to_fixed) * in_message.pose : in_message.pose;
  map_.update({in_message.geometry, pose, cells.hit.data(), cells.free.data(), cells.floor.data(), may_clear,
               cells.header.stamp.toSec()},
              placement.robot_to_fixed.translation().head<2>());
}

void MapIntake::clear()
{
  map_ = mapping::PolygonMap(map_.parameters());
  sources_.reset();
  slab_height_ = 0.0F;
  newest_ = ros::Time();
}

}  // namespace polygonal_perception::ros_mapping

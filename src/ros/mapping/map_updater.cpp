#include "ros/mapping/map_updater.hpp"

#include <polygonal_perception/FloorPlane.h>

#include <algorithm>
#include <cmath>

#include "polygonal_perception/parameters/parameter_check.hpp"
#include "ros/mapping/cells_reading.hpp"
#include "ros/mapping/map_archive.hpp"

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

MapUpdater::MapUpdater(const PolygonMapParameters& parameters, const std::vector<std::string>& sources,
                       const MapOutputs& outputs, ros_common::FrameStatistics& statistics,
                       ros_common::ThrottledLog& log)
    : parameters_(parameters),
      outputs_(outputs),
      statistics_(statistics),
      log_(log),
      sources_(sources),
      map_(parameters.map)
{
}

bool MapUpdater::process(std::size_t source, const ObservedCells& cells, bool may_wait)
{
  if (const std::string error = cellsError(cells); !error.empty()) {
    reject("cells", sources_.name(source) + ": " + error);
    return true;
  }
  if (sources_.jumpsBack(source, cells.header.stamp)) resetTime("stamps of " + sources_.name(source));
  constexpr float kSame = 1e-4F;  // [m]
  if (slab_height_ > 0.0F && std::abs(cells.slab_height - slab_height_) > kSame) {
    reject("slabs",
           sources_.name(source) + ": slab_height is " + numberText(cells.slab_height) + " and in the map " +
               numberText(slab_height_) +
               ", accepted are sensors with the same min_height and max_height (~clear begins anew)");
    return true;
  }
  const auto placement = place(cells.header);
  if (!placement) {
    if (may_wait) return false;
    reject("tf", sources_.name(source) + ": " + placement.error());
    return true;
  }
  take(source, cells, *placement);
  return true;
}

ros_common::Expected<MapUpdater::Placement> MapUpdater::place(const std_msgs::Header& header) const
{
  using Result = ros_common::Expected<Placement>;
  const std::string& fixed = parameters_.fixed_frame;
  Placement placement{Eigen::Isometry3d::Identity(), Eigen::Isometry3d::Identity()};
  if (header.frame_id != fixed) {
    const auto grid = tf_.lookup(fixed, header.frame_id, header.stamp);
    if (!grid) return Result::failure(grid.error());
    placement.grid_to_fixed = *grid;
  }
  const auto robot = tf_.lookup(fixed, parameters_.robot_frame, header.stamp);
  if (!robot) return Result::failure(robot.error());
  placement.robot_to_fixed = *robot;
  constexpr double kFarthest = 1e6;  // [m] cells farther away have no numbers
  for (const Eigen::Isometry3d& pose : {placement.grid_to_fixed, placement.robot_to_fixed}) {
    if (!(pose.translation().norm() <= kFarthest))
      return Result::failure("tf places it farther than 1000 km from the origin of '" + fixed + "'");
  }
  return placement;
}

void MapUpdater::take(std::size_t source, const ObservedCells& cells, const Placement& placement)
{
  const bool may_clear = sources_.mayClear(source, cells.header.stamp, cells.floor_status,
                                           parameters_.max_delay, MapSources::Clock::now());
  newest_ = std::max(newest_, cells.header.stamp);
  const bool is_placed_by_tf = cells.header.frame_id != parameters_.fixed_frame;
  if (cells.floor_status == FloorPlane::FOUND && is_placed_by_tf)
    sources_.setFloor(source, placement.grid_to_fixed);
  slab_height_ = cells.slab_height;

  const CellsPlace in_message = placeOf(cells);
  const Eigen::Isometry2d pose = inPlane(placement.grid_to_fixed) * in_message.pose;
  map_.update({in_message.geometry, pose, cells.hit.data(), cells.free.data(), cells.floor.data(), may_clear,
               cells.header.stamp.toSec()},
              placement.robot_to_fixed.translation().head<2>());
  const auto made = publish(cells.header, cells.floor_status);
  statistics_.answered(made.times, made.messages);
}

MapUpdater::Published MapUpdater::publish(std_msgs::Header header, std::uint8_t floor_status)
{
  const mapping::PolygonMap::Result& result = map_.make(outputs_.needs());
  header.frame_id = parameters_.fixed_frame;
  const auto start = ros_common::FrameStatistics::Clock::now();
  outputs_.publish({header, floor_status, result, parameters_.map.inflation.robot_radius});
  return {result.times, ros_common::FrameStatistics::Clock::now() - start};
}

ros_common::Expected<std::string> MapUpdater::save(const std::string& path)
{
  return saveMap(map_, parameters_.fixed_frame, slab_height_, path);
}

ros_common::Expected<std::string> MapUpdater::load(const std::string& path)
{
  using Result = ros_common::Expected<std::string>;
  constexpr double kUsualResolution = 0.05;  // [m]
  const bool has_map = map_.map().isActive();
  const ros::Time stamp = newest_.isZero() ? ros::Time::now() : newest_;
  const auto loaded = loadMap(map_, parameters_.fixed_frame,
                              has_map ? map_.map().geometry().resolution : kUsualResolution, stamp, path);
  if (!loaded) return Result::failure(loaded.error());
  slab_height_ = static_cast<float>(loaded->slab_height);
  std_msgs::Header header;
  header.stamp = stamp;
  publish(header, FloorPlane::NOT_FOUND);
  return loaded->text;
}

void MapUpdater::configure(const PolygonMapParameters& parameters)
{
  parameters_ = parameters;
  map_.configure(parameters.map);
}

void MapUpdater::clear()
{
  map_ = mapping::PolygonMap(parameters_.map);
  sources_.reset();
  slab_height_ = 0.0F;
  newest_ = ros::Time();
}

void MapUpdater::resetTime(const std::string& reason)
{
  log_.warn("time", "time has jumped back (" + reason + "): the map begins anew");
  clear();
  tf_.clear();
}

void MapUpdater::reject(const char* kind, const std::string& reason)
{
  statistics_.rejected(reason);
  log_.error(kind, reason);
}

}  // namespace polygonal_perception::ros_mapping

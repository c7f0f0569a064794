#include "ros/mapping/map_updater.hpp"

#include <polygonal_perception/FloorPlane.h>

#include "ros/mapping/map_archive.hpp"

namespace polygonal_perception::ros_mapping {

MapUpdater::MapUpdater(const PolygonMapParameters& parameters, const std::vector<std::string>& sources,
                       const MapOutputs& outputs, ros_common::FrameStatistics& statistics,
                       ros_common::ThrottledLog& log)
    : parameters_(parameters),
      outputs_(outputs),
      statistics_(statistics),
      log_(log),
      intake_(parameters.map, sources)
{
}

bool MapUpdater::process(std::size_t source, const ObservedCells& cells, bool may_wait)
{
  const MapIntake::Admission admission = intake_.admit(source, cells);
  if (admission.time_jumped_back) forgetTime("stamps of " + sources().name(source));
  if (admission.fault != nullptr) {
    reject(admission.fault, admission.reason);
    return true;
  }
  const auto placement = place(cells.header);
  if (!placement) {
    if (may_wait) return false;
    reject("tf", sources().name(source) + ": " + placement.error());
    return true;
  }
  intake_.take(source, cells, *placement, parameters_.max_delay);
  const auto made = publish(cells.header, cells.floor_status);
  statistics_.answered(made.times, made.messages);
  return true;
}

ros_common::Expected<MapIntake::Placement> MapUpdater::place(const std_msgs::Header& header) const
{
  using Result = ros_common::Expected<MapIntake::Placement>;
  const std::string& fixed = parameters_.fixed_frame;
  MapIntake::Placement placement{std::nullopt, Eigen::Isometry3d::Identity()};
  if (header.frame_id != fixed) {
    const auto grid = tf_.lookup(fixed, header.frame_id, header.stamp);
    if (!grid) return Result::failure(grid.error());
    placement.grid_to_fixed = *grid;
  }
  const auto robot = tf_.lookup(fixed, parameters_.robot_frame, header.stamp);
  if (!robot) return Result::failure(robot.error());
  placement.robot_to_fixed = *robot;
  if (!placement.isNear())
    return Result::failure("tf places it farther than 1000 km from the origin of '" + fixed + "'");
  return placement;
}

MapUpdater::Published MapUpdater::publish(std_msgs::Header header, std::uint8_t floor_status)
{
  const mapping::PolygonMap::Result& result = intake_.map().make(outputs_.needs());
  header.frame_id = parameters_.fixed_frame;
  const auto start = ros_common::FrameStatistics::Clock::now();
  outputs_.publish({header, floor_status, result, parameters_.map.inflation.robot_radius});
  return {result.times, ros_common::FrameStatistics::Clock::now() - start};
}

ros_common::Expected<std::string> MapUpdater::save(const std::string& path)
{
  return saveMap(intake_.map(), parameters_.fixed_frame, intake_.slabHeight(), path);
}

ros_common::Expected<std::string> MapUpdater::load(const std::string& path)
{
  using Result = ros_common::Expected<std::string>;
  constexpr double kUsualResolution = 0.05;  // [m]
  mapping::PolygonMap& map = intake_.map();
  const double resolution = map.map().isActive() ? map.map().geometry().resolution : kUsualResolution;
  const ros::Time stamp = newestStamp().isZero() ? ros::Time::now() : newestStamp();
  const auto loaded = loadMap(map, parameters_.fixed_frame, resolution, stamp, path);
  if (!loaded) return Result::failure(loaded.error());
  intake_.setSlabHeight(static_cast<float>(loaded->slab_height));
  std_msgs::Header header;
  header.stamp = stamp;
  publish(header, FloorPlane::NOT_FOUND);
  return loaded->text;
}

void MapUpdater::configure(const PolygonMapParameters& parameters)
{
  parameters_ = parameters;
  intake_.configure(parameters.map);
}

void MapUpdater::resetTime(const std::string& reason)
{
  intake_.clear();
  forgetTime(reason);
}

void MapUpdater::forgetTime(const std::string& reason)
{
  log_.warn("time", "time has jumped back (" + reason + "): the map begins anew");
  tf_.clear();
}

void MapUpdater::reject(const char* kind, const std::string& reason)
{
  const std::string text = ros_common::shortened(reason);
  statistics_.rejected(text);
  log_.error(kind, text);
}

}  // namespace polygonal_perception::ros_mapping

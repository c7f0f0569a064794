#include "polygonal_perception/ros/common/grid_messages.hpp"

#include <algorithm>
#include <boost/make_shared.hpp>
#include <cmath>

namespace polygonal_perception::ros_common {

nav_msgs::MapMetaData toMetaData(const ros::Time& stamp, const occupancy::GridGeometry& geometry,
                                 const Eigen::Isometry2d& output_pose)
{
  nav_msgs::MapMetaData info;
  info.map_load_time = stamp;
  info.resolution = static_cast<float>(geometry.resolution);
  info.width = static_cast<std::uint32_t>(geometry.cells_x);
  info.height = static_cast<std::uint32_t>(geometry.cells_y);
  const Eigen::Vector2d origin = output_pose * Eigen::Vector2d(geometry.origin_x, geometry.origin_y);
  info.origin.position.x = origin.x();
  info.origin.position.y = origin.y();
  const double yaw = Eigen::Rotation2Dd(output_pose.linear()).angle();
  info.origin.orientation.z = std::sin(yaw / 2.0);
  info.origin.orientation.w = std::cos(yaw / 2.0);
  return info;
}

nav_msgs::OccupancyGridPtr toUnknownGrid(const std_msgs::Header& header,
                                         const occupancy::GridGeometry& geometry,
                                         const Eigen::Isometry2d& output_pose)
{
  constexpr std::int8_t kUnknown = -1;
  auto message = boost::make_shared<nav_msgs::OccupancyGrid>();
  message->header = header;
  message->info = toMetaData(header.stamp, geometry, output_pose);
  message->data.assign(geometry.size(), kUnknown);
  return message;
}

nav_msgs::OccupancyGridPtr toOccupancyGrid(const std_msgs::Header& header, const occupancy::BinaryGrid& grid,
                                           const Eigen::Isometry2d& output_pose)
{
  static constexpr std::int8_t kFree = 0;  // static: GCC 10 would have the lambda capture them
  static constexpr std::int8_t kOccupied = 100;
  auto message = toUnknownGrid(header, grid.geometry(), output_pose);
  std::transform(grid.cells().begin(), grid.cells().end(), message->data.begin(),
                 [](std::uint8_t cell) { return cell != 0 ? kOccupied : kFree; });
  return message;
}

nav_msgs::OccupancyGridPtr toObservedGrid(const std_msgs::Header& header,
                                          const occupancy::BinaryGrid& occupancy,
                                          const std::vector<std::uint8_t>& floor,
                                          const Eigen::Isometry2d& output_pose)
{
  constexpr std::int8_t kSeenFree = 0;
  constexpr std::int8_t kOccupied = 100;
  auto message = toUnknownGrid(header, occupancy.geometry(), output_pose);
  for (std::size_t cell = 0; cell < message->data.size(); ++cell) {
    if (occupancy.cells()[cell] != 0) {
      message->data[cell] = kOccupied;
    } else if (floor[cell] != 0) {
      message->data[cell] = kSeenFree;
    }
  }
  return message;
}

}  // namespace polygonal_perception::ros_common

#include "ros/mapping/map_outputs.hpp"

#include <nav_msgs/OccupancyGrid.h>
#include <visualization_msgs/MarkerArray.h>

#include <boost/make_shared.hpp>

#include "polygonal_perception/ros/common/grid_messages.hpp"
#include "polygonal_perception/ros/common/polygon_markers.hpp"
#include "polygonal_perception/ros/common/polygon_messages.hpp"

namespace polygonal_perception::ros_mapping {

namespace {

using Products = mapping::PolygonMap::Products;

// The map lies in the fixed frame as it is.
const Eigen::Isometry2d kHere = Eigen::Isometry2d::Identity();

// A reader who came while the map was made waits for the next one: then what it reads is not there yet.

nav_msgs::OccupancyGridPtr observedGrid(const MapResult& result)
{
  if (!result.map.products.seen) return nullptr;
  return ros_common::toObservedGrid(result.header, result.map.occupied, result.map.seen, kHere);
}

nav_msgs::OccupancyGridPtr occupancyGrid(const MapResult& result)
{
  if (!result.map.products.occupied) return nullptr;
  return ros_common::toOccupancyGrid(result.header, result.map.occupied, kHere);
}

nav_msgs::OccupancyGridPtr inflatedGrid(const MapResult& result)
{
  if (!result.map.products.inflated) return nullptr;
  return ros_common::toOccupancyGrid(result.header, result.map.inflated, kHere);
}

PolygonArrayPtr polygons(const MapResult& result)
{
  if (!result.map.products.polygons) return nullptr;
  // What is remembered stands whether or not this observation had a floor: the status is put in afterwards.
  const ros_common::PolygonContext context{result.header, FloorPlane::FOUND, result.inflation_radius,
                                           result.map.occupied.geometry().bounds()};
  PolygonArrayPtr message = ros_common::toPolygonArray(context, result.map.polygons, kHere);
  message->floor_status = result.floor_status;
  return message;
}

visualization_msgs::MarkerArrayPtr markers(const MapResult& result)
{
  if (!result.map.products.polygons) return nullptr;
  auto markers = boost::make_shared<visualization_msgs::MarkerArray>();
  ros_common::appendPolygonMarkers(result.header, result.map.polygons, kHere, ros_common::kMapColor,
                                   *markers);
  return markers;
}

}  // namespace

void addOutputs(MapOutputs& outputs)
{
  Products seen;
  seen.seen = true;
  Products occupied;
  occupied.occupied = true;
  Products inflated;
  inflated.inflated = true;
  Products polygon;
  polygon.polygons = true;
  outputs.add<nav_msgs::OccupancyGrid>("observed_grid", seen, observedGrid);
  outputs.add<nav_msgs::OccupancyGrid>("occupancy_grid", occupied, occupancyGrid);
  outputs.add<nav_msgs::OccupancyGrid>("inflated_grid", inflated, inflatedGrid);
  outputs.add<PolygonArray>("polygons", polygon, polygons);
  outputs.add<visualization_msgs::MarkerArray>("markers", polygon, markers);
}

}  // namespace polygonal_perception::ros_mapping

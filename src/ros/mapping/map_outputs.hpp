#pragma once

#include <polygonal_perception/PolygonArray.h>
#include <std_msgs/Header.h>

#include <cstdint>

#include "polygonal_perception/mapping/polygon_map.hpp"
#include "polygonal_perception/ros/common/output_table.hpp"

namespace polygonal_perception::ros_mapping {

/// The map after an observation.
struct MapResult
{
  std_msgs::Header header;    ///< stamp of the observation, fixed frame
  std::uint8_t floor_status;  ///< of the observation
  const mapping::PolygonMap::Result& map;
  double inflation_radius;  ///< [m]
};

using MapOutputs = ros_common::OutputTable<MapResult, mapping::PolygonMap::Products>;

/// Adds the topics of the node: observed_grid, occupancy_grid, inflated_grid, polygons, markers.
void addOutputs(MapOutputs& outputs);

}  // namespace polygonal_perception::ros_mapping

#pragma once

#include <ros/time.h>

#include <string>

#include "polygonal_perception/mapping/polygon_map.hpp"
#include "polygonal_perception/ros/common/expected.hpp"

namespace polygonal_perception::ros_mapping {

/// Writes a map to PATH, and map_server's image and description of it beside it, with the endings .pgm and .yaml.
/// @param path  a .geojson or .json; another one gets .geojson as its end
/// @return what was written, or why not
ros_common::Expected<std::string> saveMap(mapping::PolygonMap& map, const std::string& frame_id,
                                          double slab_height, const std::string& path);

/// A map that was read.
struct LoadedMap
{
  std::string text;          ///< what it is
  double slab_height = 0.0;  ///< [m] 0: any
};

/// Puts a file in the place of the map, which stays as it is where that fails.
/// @param resolution  [m] of a file that was drawn by hand
ros_common::Expected<LoadedMap> loadMap(mapping::PolygonMap& map, const std::string& frame_id,
                                        double resolution, const ros::Time& stamp, const std::string& path);

}  // namespace polygonal_perception::ros_mapping

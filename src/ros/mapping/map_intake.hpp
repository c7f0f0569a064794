#pragma once

#include <polygonal_perception/ObservedCells.h>
#include <ros/time.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "polygonal_perception/mapping/polygon_map.hpp"
#include "ros/mapping/map_sources.hpp"

namespace polygonal_perception::ros_mapping {

/// Looks at what anybody may have sent and takes it into the map, where it is told that it lies. It is what of the map's
/// updater needs no ROS around it.
class MapIntake
{
public:
  MapIntake(const mapping::PolygonMap::Parameters& parameters, const std::vector<std::string>& sources);

  /// What is to become of a message.
  struct Admission
  {
    bool time_jumped_back = false;  ///< all before is forgotten
    const char* fault = nullptr;    ///< a kind of what is wrong with it; nothing: it may be taken
    std::string reason;             ///< with the field, what it is and what is accepted
  };
  Admission admit(std::size_t source, const ObservedCells& cells);

  /// Where an observation and the robot are.
  struct Placement
  {
    std::optional<Eigen::Isometry3d> grid_to_fixed;  ///< nothing: the cells are in the fixed frame
    Eigen::Isometry3d robot_to_fixed;

    /// False where something lies so far away that cells have no numbers.
    bool isNear() const;
  };
  /// @param max_delay  [s] by which it may be older than the newest one and still clear
  /// @pre admit() has found nothing wrong with it, and placement.isNear()
  void take(std::size_t source, const ObservedCells& cells, const Placement& placement, double max_delay);

  void configure(const mapping::PolygonMap::Parameters& parameters) { map_.configure(parameters); }
  /// Forgets the map, and when observations came.
  void clear();

  mapping::PolygonMap& map() { return map_; }
  const MapSources& sources() const { return sources_; }
  const ros::Time& newestStamp() const { return newest_; }
  /// [m] Of what is in the map; 0: of any height.
  float slabHeight() const { return slab_height_; }
  void setSlabHeight(float height) { slab_height_ = height; }

private:
  MapSources sources_;
  mapping::PolygonMap map_;
  float slab_height_ = 0.0F;
  ros::Time newest_;
};

}  // namespace polygonal_perception::ros_mapping

#pragma once

#include <polygonal_perception/ObservedCells.h>

#include <memory>
#include <string>
#include <vector>

#include "polygonal_perception/ros/common/expected.hpp"
#include "polygonal_perception/ros/common/frame_statistics.hpp"
#include "polygonal_perception/ros/common/tf_bridge.hpp"
#include "polygonal_perception/ros/common/throttled_log.hpp"
#include "ros/mapping/map_intake.hpp"
#include "ros/mapping/map_outputs.hpp"
#include "ros/mapping/polygon_map_parameters.hpp"

namespace polygonal_perception::ros_mapping {

/// Takes observations into the map, each placed by tf at its own stamp, and answers each.
class MapUpdater
{
public:
  MapUpdater(const PolygonMapParameters& parameters, const std::vector<std::string>& sources,
             const MapOutputs& outputs, ros_common::FrameStatistics& statistics,
             ros_common::ThrottledLog& log);

  /// @param may_wait  whether it may come again when its transforms are not there yet
  /// @return false: it is to come again
  bool process(std::size_t source, const ObservedCells& cells, bool may_wait);

  void configure(const PolygonMapParameters& parameters);
  /// Forgets the map, and when observations came.
  void clear() { intake_.clear(); }
  /// Time has jumped back: forgets the transforms, too.
  void resetTime(const std::string& reason);
  const ros::Time& newestStamp() const { return intake_.newestStamp(); }

  /// @return what was done, or why not
  ros_common::Expected<std::string> save(const std::string& path);
  /// The map is published once it is loaded.
  ros_common::Expected<std::string> load(const std::string& path);

  const MapSources& sources() const { return intake_.sources(); }

private:
  ros_common::Expected<MapIntake::Placement> place(const std_msgs::Header& header) const;
  struct Published
  {
    mapping::PolygonMap::StageTimes times;
    ros_common::FrameStatistics::Clock::duration messages;
  };
  Published publish(std_msgs::Header header, std::uint8_t floor_status);
  void forgetTime(const std::string& reason);
  void reject(const char* kind, const std::string& reason);

  PolygonMapParameters parameters_;
  const MapOutputs& outputs_;
  ros_common::FrameStatistics& statistics_;
  ros_common::ThrottledLog& log_;
  ros_common::TfBridge tf_;
  MapIntake intake_;
};

}  // namespace polygonal_perception::ros_mapping

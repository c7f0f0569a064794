#include "ros/mapping/map_sources.hpp"

#include <polygonal_perception/FloorPlane.h>

#include <algorithm>
#include <cmath>

#include "polygonal_perception/geometry/angle.hpp"
#include "polygonal_perception/parameters/parameter_check.hpp"

namespace polygonal_perception::ros_mapping {

using parameters::numberText;

MapSources::MapSources(const std::vector<std::string>& names)
{
  for (const std::string& name : names) {
    Source source;
    source.name = name;
    sources_.push_back(source);
  }
}

bool MapSources::mayClear(std::size_t index, const ros::Time& stamp, std::uint8_t floor_status,
                          double max_delay, Clock::time_point now)
{
  Source& source = sources_[index];
  const bool is_repeated = stamp <= source.stamps.newest();
  source.is_late = ros_common::isOlder(stamp, newest_, max_delay);
  source.floor_status = floor_status;
  source.last_arrival = now;
  source.stamps.take(stamp);
  newest_ = std::max(newest_, stamp);
  return floor_status == FloorPlane::FOUND && !source.is_late && !is_repeated;
}

void MapSources::setFloor(std::size_t source, const std::optional<Eigen::Isometry3d>& grid_to_fixed)
{
  sources_[source].floor_up.reset();
  if (!grid_to_fixed) return;
  sources_[source].floor_up = grid_to_fixed->linear().col(2);
  sources_[source].floor_height = grid_to_fixed->translation().z();
}

void MapSources::reset()
{
  for (Source& source : sources_) source.stamps.reset();
  newest_ = ros::Time();
}

std::string MapSources::complaint(std::size_t index, Clock::time_point now) const
{
  constexpr double kSilence = 1.0;  // [s]
  const Source& source = sources_[index];
  if (!source.last_arrival) return "nothing has come yet";
  const double silence = std::chrono::duration<double>(now - *source.last_arrival).count();
  if (silence > kSilence) return "silent for " + numberText(std::round(10.0 * silence) / 10.0) + " s";
  if (source.floor_status == FloorPlane::NOT_FOUND) return "no floor";
  if (source.is_late) return "late: its observations clear nothing";
  return {};
}

std::string MapSources::disagreement() const
{
  // What two floors of a calibrated robot stay within by far: their own errors are a tenth of a degree and some millimetres.
  constexpr double kTilt = 0.035;   // [rad] 2 degrees
  constexpr double kHeight = 0.03;  // [m] as min_height: more makes obstacles of floor
  for (std::size_t a = 0; a < sources_.size(); ++a) {
    for (std::size_t b = a + 1; b < sources_.size(); ++b) {
      const Source& first = sources_[a];
      const Source& second = sources_[b];
      if (!first.floor_up || !second.floor_up) continue;
      const double tilt = geometry::angleBetween(*first.floor_up, *second.floor_up);
      const double height = second.floor_height - first.floor_height;
      if (tilt <= kTilt && std::abs(height) <= kHeight) continue;
      return "the floor of " + second.name + " is tilted by " +
             numberText(std::round(10.0 * tilt / geometry::kDegree) / 10.0) + " degrees against that of " +
             first.name + " and " + numberText(std::round(1e3 * height) / 1e3) +
             " m higher: tf is wrong about one of them";
    }
  }
  return {};
}

}  // namespace polygonal_perception::ros_mapping

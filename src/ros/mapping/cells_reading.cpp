#include "ros/mapping/cells_reading.hpp"

#include <algorithm>
#include <cmath>

#include "polygonal_perception/parameters/parameter_check.hpp"
#include "polygonal_perception/ros/common/planar_pose.hpp"
#include "polygonal_perception/ros/common/text_rules.hpp"

namespace polygonal_perception::ros_mapping {

using parameters::numberText;

CellsPlace placeOf(const ObservedCells& cells)
{
  CellsPlace place;
  place.geometry.cells_x = static_cast<int>(cells.info.width);
  place.geometry.cells_y = static_cast<int>(cells.info.height);
  // A float's 0.05 is 0.05: the map's lattice is made of it.
  constexpr double kMicrometres = 1e6;
  place.geometry.resolution = std::round(kMicrometres * cells.info.resolution) / kMicrometres;
  place.pose = Eigen::Translation2d(cells.info.origin.position.x, cells.info.origin.position.y) *
               Eigen::Rotation2Dd(ros_common::yawOf(cells.info.origin.orientation));
  return place;
}

std::string cellsError(const ObservedCells& cells)
{
  constexpr double kMostCells = 4e6;   // more take seconds
  constexpr double kSmallest = 0.001;  // [m]
  if (std::string error = ros_common::frameIdError(cells.header.frame_id); !error.empty()) return error;
  const double resolution = cells.info.resolution;
  if (!(resolution >= kSmallest && resolution <= 10.0))
    return "info.resolution is " + numberText(resolution) + ", accepted is 0.001 to 10 m";
  if (!(cells.slab_height > 0.0F && std::isfinite(cells.slab_height)))
    return "slab_height is " + numberText(cells.slab_height) + ", accepted is a finite number above 0 m";
  // Of none, too, both sides are counted through.
  const auto side = [](std::uint32_t cells) { return std::max(1.0, static_cast<double>(cells)); };
  if (side(cells.info.width) * side(cells.info.height) > kMostCells) {
    return "info.width x info.height is " + std::to_string(cells.info.width) + " x " +
           std::to_string(cells.info.height) + ", accepted are at most 4e6 cells";
  }
  const std::size_t size = std::size_t{cells.info.width} * cells.info.height;
  const struct
  {
    const char* name;
    std::size_t size;
  } layers[] = {{"hit", cells.hit.size()}, {"free", cells.free.size()}, {"floor", cells.floor.size()}};
  for (const auto& layer : layers) {
    if (layer.size != size) {
      return std::string(layer.name) + " has " + std::to_string(layer.size) + " cells, accepted is " +
             std::to_string(size) + ", info.width times info.height";
    }
  }
  const auto& origin = cells.info.origin;
  if (!ros_common::isPlace(origin.position) || !ros_common::isRotation(origin.orientation))
    return "info.origin is no pose: accepted is a place within 1000 km and a unit quaternion";
  return {};
}

}  // namespace polygonal_perception::ros_mapping

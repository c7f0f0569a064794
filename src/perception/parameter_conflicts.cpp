#include "polygonal_perception/perception/pipeline.hpp"

namespace polygonal_perception::perception {

using parameters::numberText;
using parameters::ParameterFault;

namespace {

/// Beyond this a frame would take seconds and hundreds of megabytes.
constexpr double kMostCells = 4e6;

std::optional<ParameterFault> findTooManyCells(const occupancy::GridParameters& grid)
{
  const double cells =
      (grid.grid_length + grid.grid_behind) / grid.grid_resolution * (grid.grid_width / grid.grid_resolution);
  if (cells <= kMostCells) return std::nullopt;
  return ParameterFault{{"grid_length", "grid_behind", "grid_width", "grid_resolution"},
                        "grid_length " + numberText(grid.grid_length) + ", grid_behind " +
                            numberText(grid.grid_behind) + " and grid_width " + numberText(grid.grid_width) +
                            " at grid_resolution " + numberText(grid.grid_resolution) + " make " +
                            numberText(cells) + " cells, accepted are at most " + numberText(kMostCells)};
}

}  // namespace

std::optional<ParameterFault> Pipeline::Parameters::conflict() const
{
  if (range.max_range > 0.0) {
    if (auto fault = parameters::findDisorder("min_range", range.min_range, "max_range", range.max_range))
      return fault;
  }
  if (auto fault = parameters::findDisorder("min_height", projection.min_height, "max_height",
                                            projection.max_height)) {
    return fault;
  }
  if (auto fault = parameters::findDisorder("min_camera_height", detector.selection.min_camera_height,
                                            "max_camera_height", detector.selection.max_camera_height)) {
    return fault;
  }
  if (auto fault = findTooManyCells(grid)) return fault;
  if (!scan.coversView()) {
    if (auto fault = parameters::findDisorder("scan_angle_min", scan.scan_angle_min, "scan_angle_max",
                                              scan.scan_angle_max)) {
      return fault;
    }
  }
  if (!(tracker.initial_up.norm() > 0.0)) {
    return ParameterFault{{"initial_up"}, "initial_up is a zero vector, accepted is any other direction"};
  }
  return std::nullopt;
}

}  // namespace polygonal_perception::perception

#include "polygonal_perception/mapping/map_file.hpp"

#include <cmath>
#include <set>

#include "mapping/json_document.hpp"
#include "mapping/map_faults.hpp"
#include "mapping/number_text.hpp"
#include "polygonal_perception/geometry/validity.hpp"

namespace polygonal_perception::mapping {

namespace {

/// A number of a text, also one that no file can hold.
std::string anyText(double value)
{
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value > 0.0 ? "infinite" : "-infinite";
  return shortText(value);
}

/// As geometry/predicates.hpp wants them.
bool isCoordinate(double value)
{
  constexpr double kLeast = 1e-100;
  constexpr double kMost = 1e100;
  return value == 0.0 || (std::abs(value) >= kLeast && std::abs(value) <= kMost);
}

bool isText(const std::string& text)
{
  try {
    (void)Json(text).dump();
    return true;
  } catch (const Json::type_error&) {
    return false;
  }
}

}  // namespace

std::optional<std::string> findPolygonFault(const geometry::PolygonSet& polygons)
{
  if (polygons.vertices.size() > kMostSavedVertices) {
    return "there are " + std::to_string(polygons.vertices.size()) + " vertices, accepted are at most " +
           std::to_string(kMostSavedVertices);
  }
  for (std::size_t r = 0; r < polygons.rings.size(); ++r) {
    for (const Eigen::Vector2d& vertex : polygons.view(polygons.rings[r])) {
      if (isCoordinate(vertex.x()) && isCoordinate(vertex.y())) continue;
      return "ring " + std::to_string(r) + " has a vertex at (" + anyText(vertex.x()) + ", " +
             anyText(vertex.y()) + "), accepted are coordinates of 1e-100 to 1e100 m either way, and 0";
    }
  }
  const auto defect = geometry::findDefect(polygons);
  return defect ? std::optional(defect->text) : std::nullopt;
}

std::optional<std::string> findRadiusFault(double inflation_radius)
{
  if (std::isfinite(inflation_radius) && inflation_radius >= 0.0) return std::nullopt;
  return "inflation_radius is " + anyText(inflation_radius) + ", accepted is a finite number from 0 [m]";
}

std::optional<std::string> findGridFault(int cells_x, int cells_y, double resolution, double origin_x,
                                         double origin_y)
{
  const std::string size = std::to_string(cells_x) + " x " + std::to_string(cells_y);
  if (cells_x < 1 || cells_y < 1) return "there are " + size + ", accepted is at least 1 x 1";
  const std::size_t count = static_cast<std::size_t>(cells_x) * static_cast<std::size_t>(cells_y);
  if (count > kMostSavedCells)
    return "there are " + size + ", accepted are at most " + std::to_string(kMostSavedCells);
  if (!std::isfinite(resolution) || resolution <= 0.0)
    return "resolution is " + anyText(resolution) + ", accepted is a finite number above 0 [m]";
  if (std::isfinite(origin_x) && std::isfinite(origin_y)) return std::nullopt;
  return "the origin is (" + anyText(origin_x) + ", " + anyText(origin_y) +
         "), accepted are finite numbers [m]";
}

std::optional<std::string> findCellsFault(const SavedCells& cells)
{
  if (auto fault =
          findGridFault(cells.cells_x, cells.cells_y, cells.resolution, cells.origin_x, cells.origin_y))
    return "cells: " + *fault;
  if (!std::isfinite(cells.slab_height) || cells.slab_height < 0.0)
    return "cells: slab_height is " + anyText(cells.slab_height) + ", accepted is a finite number from 0 [m]";
  if (cells.layers.size() > kMostSavedLayers)
    return "cells: there are more than " + std::to_string(kMostSavedLayers) + " layers";
  const std::size_t count = static_cast<std::size_t>(cells.cells_x) * static_cast<std::size_t>(cells.cells_y);
  std::set<std::string> names;
  for (std::size_t k = 0; k < cells.layers.size(); ++k) {
    const CellLayer& layer = cells.layers[k];
    const std::string which = "cells, layer " + std::to_string(k);
    if (!isText(layer.name)) return which + ": the name is no UTF-8";
    if (!names.insert(layer.name).second) return which + ": there are two of the name " + shown(layer.name);
    if (layer.values.size() != count) {
      return which + ": there are " + std::to_string(layer.values.size()) + " values, accepted are " +
             std::to_string(cells.cells_x) + " x " + std::to_string(cells.cells_y);
    }
  }
  if (count * cells.layers.size() <= kMostSavedCells) return std::nullopt;
  return "cells: all layers together have more than " + std::to_string(kMostSavedCells) + " values";
}

std::optional<MapFileError> findFault(const MapFile& map)
{
  if (!isText(map.frame_id)) return MapFileError{"the frame_id is no UTF-8"};
  if (auto fault = findRadiusFault(map.inflation_radius)) return MapFileError{*fault};
  if (auto fault = findPolygonFault(map.polygons)) return MapFileError{*fault};
  if (!map.cells) return std::nullopt;
  if (auto fault = findCellsFault(*map.cells)) return MapFileError{*fault};
  return std::nullopt;
}

}  // namespace polygonal_perception::mapping

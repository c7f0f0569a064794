#pragma once

#include <cstdint>
#include <vector>

#include "polygonal_perception/polygon_set.hpp"

namespace polygonal_perception {

/// Cuts polygons with holes into triangles, to be drawn: ear clipping, each hole joined to its boundary by a
/// bridge first.
///
/// Meant for pictures: rings that break the polygon contract (that cross themselves, say) still give
/// triangles, though not of their exact area.
///
/// @return three indices into polygons.vertices a triangle, counter-clockwise
std::vector<std::uint32_t> triangulate(const PolygonSet& polygons);

}  // namespace polygonal_perception

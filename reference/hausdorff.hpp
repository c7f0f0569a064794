#pragma once

#include "polygonal_perception/geometry/polygon_set.hpp"

namespace polygonal_perception::reference {

/// The Hausdorff distance between the outlines of two sets of polygons, holes included [m]: how far a point
/// of either outline is from the other one at most. It is infinite when one of them is empty, 0 when both
/// are.
/// @param step  [m] outlines are sampled at least this densely; the result is at most half of it too small
double hausdorffDistance(const geometry::PolygonSet& a, const geometry::PolygonSet& b, double step = 0.01);

}  // namespace polygonal_perception::reference

#pragma once

#include <cstddef>

#include "polygonal_perception/occupancy/polygons/outlines.hpp"

namespace polygonal_perception::occupancy {

/// How many vertices a simplification takes that may leave the outlines' corners on either side, about. It
/// stands for plain Douglas-Peucker, which the polygon contract compares with, at a small part of its cost.
/// @param tolerance  [cells] how far from a line corners may be
std::size_t estimateVertices(const Outlines& outlines, double tolerance);

}  // namespace polygonal_perception::occupancy

#pragma once

#include <random>

#include "polygonal_perception/geometry/polygon_set.hpp"

namespace polygonal_perception::reference {

/// Obstacles that break their contract in most ways in which a message can: rings that cross themselves and others, run the
/// wrong way, come twice, fold back on themselves, repeat vertices, touch, or lie outside of what they are holes of;
/// coordinates that nearly coincide, are huge or no numbers. A few are valid.
geometry::PolygonSet brokenObstacles(std::mt19937& random);

/// A place among them: anywhere, at a vertex, on an edge, or beside one by rounding; at times no number.
Eigen::Vector2d brokenPlace(std::mt19937& random, const geometry::PolygonSet& obstacles);

}  // namespace polygonal_perception::reference

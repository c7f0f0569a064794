#pragma once

#include <random>

#include "polygonal_perception/geometry/polygon_set.hpp"

namespace polygonal_perception::reference {

/// Where the coordinates of random obstacles lie.
enum class Raster
{
  kCoarse,  ///< multiples of 0.25 m: many points in one line
  kFloat    ///< anywhere, as a message's floats
};

/// A point in a square, from 0 to `size` in x and y [m].
Eigen::Vector2d randomPoint(std::mt19937& random, double low, double high, Raster raster);

/// Valid obstacles (geometry::findDefect) in a square from 0 to `size` [m]: stars, boxes and walls with corners, at times in a
/// room, with holes that hold more.
///
/// @param count  how many are tried; those that would touch others are left out
geometry::PolygonSet randomObstacles(std::mt19937& random, std::size_t count, double size, Raster raster);

}  // namespace polygonal_perception::reference

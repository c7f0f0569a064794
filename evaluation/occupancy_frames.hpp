#pragma once

#include <string>
#include <vector>

#include "polygonal_perception/occupancy/grid/binary_grid.hpp"

namespace polygonal_perception::evaluation {

/// Occupancy grids of one kind of frames.
struct OccupancySet
{
  std::string name;
  std::vector<occupancy::BinaryGrid> grids;
};

/// Of a robot's drives through a scene, `drives` of them with a layout each.
OccupancySet renderOccupancy(const std::string& scene, int drives, int frames_each);
/// Of recorded frames. @throws std::runtime_error that says what cannot be read
OccupancySet readOccupancy(const std::string& frames_json);
/// Grids of noise, blobs, lines, spirals and so on, 100 x 100 cells.
OccupancySet randomOccupancy(int count);

}  // namespace polygonal_perception::evaluation

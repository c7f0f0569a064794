#pragma once

#include <cstdint>
#include <vector>

namespace polygonal_perception::perception {

/// What a frame shows in each cell of a grid, in the grid's order. Nobody has looked where all are 0: behind something,
/// beside the view, or where the sensor has no return. `free` is empty where it was not asked for.
struct ObservedCells
{
  /// Between min_height and max_height there are so many slabs of one height.
  static constexpr int kSlabs = 8;

  std::vector<std::uint8_t> floor;  ///< 1: the floor itself was seen there
  std::vector<std::uint8_t> hit;    ///< bit k: a point was seen in the slab k, from below
  std::vector<std::uint8_t> free;   ///< bit k: the camera looked through the slab and saw something behind it

  void clear()
  {
    floor.clear();
    hit.clear();
    free.clear();
  }
};

}  // namespace polygonal_perception::perception

#pragma once

#include <cstdint>
#include <vector>

namespace polygonal_perception::occupancy {

/// What a frame shows in each cell of a grid, in the grid's order. Nobody has looked where all are 0: behind something,
/// beside the view, or where the sensor has no return. `free` is empty where it was not asked for.
struct ObservedCells
{
  /// Between min_height and max_height there are so many slabs of one height.
  static constexpr int kSlabs = 8;

  /// What of the floor was seen in a cell.
  static constexpr std::uint8_t kNothing = 0;
  static constexpr std::uint8_t kSeen = 1;     ///< a point of it
  static constexpr std::uint8_t kBetween = 2;  ///< points before and behind it, in one column of the image

  std::vector<std::uint8_t> floor;  ///< kNothing, kSeen or kBetween
  std::vector<std::uint8_t> hit;    ///< bit k: a point was seen in the slab k, from below
  std::vector<std::uint8_t> free;   ///< bit k: the camera looked through the slab and saw something behind it

  void clear()
  {
    floor.clear();
    hit.clear();
    free.clear();
  }
};

}  // namespace polygonal_perception::occupancy

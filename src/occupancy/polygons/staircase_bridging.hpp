#pragma once

#include <cstdint>
#include <vector>

#include "occupancy/polygons/proximity.hpp"
#include "polygonal_perception/occupancy/grid/bit_grid.hpp"
#include "polygonal_perception/occupancy/polygons/outlines.hpp"

namespace polygonal_perception::occupancy {

/// Bridges the small steps of slanted outlines: an inward corner between a side of one cell and one of at
/// most two is cut off by the line between the sides' ends. It is what Simplification would do first; done
/// here, where the cells themselves tell that nothing is in the way, it costs a tenth.
class StaircaseBridging
{
public:
  /// @param cells      what the outlines were traced from
  /// @param proximity  the limit that no bridge may go beyond
  void bridge(const BitGrid& cells, Proximity& proximity, Outlines& outlines);

private:
  bool isBridgeable(const BitGrid& cells, Proximity& proximity, const Outlines& outlines,
                    std::uint32_t vertex) const;

  std::vector<std::uint8_t> bridged_;  ///< of a vertex
};

}  // namespace polygonal_perception::occupancy

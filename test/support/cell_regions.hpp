#pragma once

#include <utility>
#include <vector>

#include "polygonal_perception/occupancy/grid/binary_grid.hpp"

namespace polygonal_perception::test {

/// The regions of a grid by flood fill: occupied cells that meet in a side or a corner belong together, free
/// ones that meet in a side. Space outside of the grid is free, and region 0.
class CellRegions
{
public:
  explicit CellRegions(const occupancy::BinaryGrid& grid)
      : grid_(grid), region_(static_cast<std::size_t>((grid.cellsX() + 2) * (grid.cellsY() + 2)), -1)
  {
    for (int j = -1; j <= grid.cellsY(); ++j) {
      for (int i = -1; i <= grid.cellsX(); ++i) {
        if (at(i, j) < 0) fill(i, j);
      }
    }
  }

  bool occupied(int i, int j) const { return isInside(i, j) && grid_.occupied(i, j); }
  /// The region of a cell, from -1 to one beyond the grid's last.
  int at(int i, int j) const { return region_[index(i, j)]; }
  /// How many cells belong to a region; of region 0 also those of the frame round the grid.
  int size(int region) const { return sizes_[static_cast<std::size_t>(region)]; }

  int occupiedRegions() const { return occupied_regions_; }
  /// Without the one outside.
  int enclosedFreeRegions() const { return static_cast<int>(sizes_.size()) - occupied_regions_ - 1; }

private:
  bool isInside(int i, int j) const { return i >= 0 && j >= 0 && i < grid_.cellsX() && j < grid_.cellsY(); }
  std::size_t index(int i, int j) const
  {
    return static_cast<std::size_t>((j + 1) * (grid_.cellsX() + 2) + i + 1);
  }

  void fill(int i, int j)
  {
    const auto region = static_cast<int>(sizes_.size());
    const bool kind = occupied(i, j);
    sizes_.push_back(0);
    occupied_regions_ += kind ? 1 : 0;
    std::vector<std::pair<int, int>> waiting = {{i, j}};
    region_[index(i, j)] = region;
    while (!waiting.empty()) {
      const auto [x, y] = waiting.back();
      waiting.pop_back();
      ++sizes_.back();
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const int k = x + dx;
          const int l = y + dy;
          if (k < -1 || l < -1 || k > grid_.cellsX() || l > grid_.cellsY()) continue;
          if ((!kind && dx != 0 && dy != 0) || occupied(k, l) != kind || at(k, l) >= 0) continue;
          region_[index(k, l)] = region;
          waiting.emplace_back(k, l);
        }
      }
    }
  }

  occupancy::BinaryGrid grid_;
  std::vector<int> region_;
  std::vector<int> sizes_;
  int occupied_regions_ = 0;
};

}  // namespace polygonal_perception::test

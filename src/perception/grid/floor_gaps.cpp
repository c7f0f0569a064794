#include "perception/grid/floor_gaps.hpp"

#include <algorithm>
#include <cstdlib>

#include "polygonal_perception/occupancy/grid/observed_cells.hpp"

namespace polygonal_perception::perception {

void FloorGaps::begin(const occupancy::GridGeometry& geometry)
{
  size_ = static_cast<std::uint32_t>(geometry.size());
  columns_ = geometry.cells_x;
  before_.clear();
  row_before_ = 0;
  rows_alike_ = 0;
  cells_per_row_ = 1.0F;
}

int FloorGaps::distance(std::uint32_t a, std::uint32_t b) const
{
  const int i = static_cast<int>(a - 1) % columns_ - static_cast<int>(b - 1) % columns_;
  const int j = static_cast<int>(a - 1) / columns_ - static_cast<int>(b - 1) / columns_;
  return std::max(std::abs(i), std::abs(j));
}

void FloorGaps::fill(std::uint32_t v, const CellScanner::Row& row, std::uint8_t* floor)
{
  // With less than this to a row the next few are left out. An average, since rows that run along the grid's come into
  // another cell all at once.
  constexpr float kCellsPerRow = 0.1F;
  constexpr float kNewest = 0.25F;
  constexpr std::uint32_t kLeftOut = 3;
  compared_ = 0;
  moved_ = 0;
  const std::uint32_t rows = v - row_before_;
  auto before = before_.begin();
  for (const CellBlock& here : row) {
    while (before != before_.end() && before->first < here.first) ++before;
    if (before == before_.end()) break;
    if (before->first == here.first && rows <= 1 + kLeftOut)
      fillBlock(here, *before, rows == 1 ? floor : nullptr);
  }
  if (compared_ > 0) {
    const float moved = static_cast<float>(moved_) / static_cast<float>(rows * compared_);
    cells_per_row_ += kNewest * (moved - cells_per_row_);
  } else {
    cells_per_row_ = 1.0F;
  }
  rows_alike_ = cells_per_row_ < kCellsPerRow ? kLeftOut : 0;
  before_.assign(row.begin(), row.end());
  row_before_ = v;
}

void FloorGaps::fillBlock(const CellBlock& here, const CellBlock& before, std::uint8_t* floor)
{
  // Where cells are taller than the rows are apart, which is most of an image, a look at a few pixels tells.
  constexpr std::uint32_t kLook = 8;
  bool is_apart = false;
  for (std::uint32_t lane = 0; lane < kBlock; lane += kLook) {
    const std::uint32_t a = here.cell[lane];
    const std::uint32_t b = before.cell[lane];
    if (!isFloor(a) || !isFloor(b)) continue;
    ++compared_;
    if (a == b) continue;
    ++moved_;
    is_apart = is_apart || distance(a, b) > 1;
  }
  if (!is_apart || floor == nullptr) return;
  // Cells between two that are farther apart would not all lie beside one in which a point is.
  constexpr int kFarthest = 3;
  for (std::uint32_t lane = 0; lane < kBlock; ++lane) {
    const std::uint32_t a = here.cell[lane];
    const std::uint32_t b = before.cell[lane];
    if (a == b || !isFloor(a) || !isFloor(b)) continue;
    const int steps = distance(a, b);
    if (steps < 2 || steps > kFarthest) continue;
    const int i = static_cast<int>(a - 1) % columns_;
    const int j = static_cast<int>(a - 1) / columns_;
    const int di = static_cast<int>(b - 1) % columns_ - i;
    const int dj = static_cast<int>(b - 1) / columns_ - j;
    for (int step = 1; step < steps; ++step) {
      // Rounded to the nearer cell.
      const int x = i + (2 * di * step + (di < 0 ? -steps : steps)) / (2 * steps);
      const int y = j + (2 * dj * step + (dj < 0 ? -steps : steps)) / (2 * steps);
      std::uint8_t& between = floor[y * columns_ + x];
      if (between == occupancy::ObservedCells::kNothing) between = occupancy::ObservedCells::kBetween;
    }
  }
}

}  // namespace polygonal_perception::perception

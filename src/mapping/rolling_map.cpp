#include "polygonal_perception/mapping/rolling_map.hpp"

#include <algorithm>
#include <cmath>

namespace polygonal_perception::mapping {

using occupancy::GridGeometry;

namespace {

/// Which squares of the map's lattice a square of a grid reaches into that is turned against it: those that no side of
/// either keeps apart.
class SquareOverlap
{
public:
  /// @param turned, straight  [m] sides of the grid's and of the map's cells
  SquareOverlap(const Eigen::Matrix2d& rotation, double turned, double straight)
      : c_(rotation(0, 0)), s_(rotation(1, 0))
  {
    const double shadow = std::abs(c_) + std::abs(s_);  // of a turned square of side 1
    // Squares that only touch, as those of one lattice do, do not overlap, however numbers are rounded.
    constexpr double kRounding = 1e-9;
    of_straight_ = 0.5 * (straight + turned * shadow) - kRounding;
    of_turned_ = 0.5 * (turned + straight * shadow) - kRounding;
  }

  /// [m] How far apart along x or y two middles may be.
  double reach() const { return of_straight_; }
  /// @param dx, dy  [m] from one middle to the other
  bool overlap(double dx, double dy) const
  {
    return std::abs(dx) < of_straight_ && std::abs(dy) < of_straight_ &&
           std::abs(c_ * dx + s_ * dy) < of_turned_ && std::abs(c_ * dy - s_ * dx) < of_turned_;
  }

private:
  double c_, s_;
  double of_straight_, of_turned_;
};

/// Places so far away that cells have no numbers count as just as far as they have.
int cellBelow(double place, double resolution)
{
  constexpr double kFarthest = 1e9;
  return static_cast<int>(std::clamp(std::floor(place / resolution), -kFarthest, kFarthest));
}

}  // namespace

/// Which steps along a row of the map lie in a grid, whose sides lie across it.
struct RollingMap::Steps
{
  double first, last;

  /// Keeps those at which offset + step k is from 0 to just below `size`.
  void clip(double offset, double step, int size)
  {
    constexpr double kRounding = 1e-6;
    const double low = kRounding - offset;
    const double high = size - kRounding - offset;
    if (step == 0.0) {
      if (low > 0.0 || high < 0.0) last = first - 1.0;
      return;
    }
    first = std::max(first, std::min(low / step, high / step));
    last = std::min(last, std::max(low / step, high / step));
  }
};

void RollingMap::configure(const Parameters& parameters)
{
  const bool is_other_square = parameters.map_size != parameters_.map_size;
  parameters_ = parameters;
  if (!is_other_square || !isActive()) return;
  std::vector<std::uint8_t> heights;
  std::vector<std::uint8_t> seen;
  copyHeights(heights);
  copySeen(seen);
  restore(geometry(), heights, seen, newest_stamp_);
}

void RollingMap::reset(double resolution)
{
  resolution_ = resolution;
  cells_ = static_cast<int>(std::clamp(std::round(parameters_.map_size / resolution), 1.0, kMostCells));
  const auto size = static_cast<std::size_t>(cells_) * static_cast<std::size_t>(cells_);
  heights_.assign(size, 0);
  seen_.assign(size, 0);
  views_.assign(size, Views{});
}

void RollingMap::moveTo(const Eigen::Vector2d& middle)
{
  const int x = cellBelow(middle.x(), resolution_) - cells_ / 2;
  const int y = cellBelow(middle.y(), resolution_) - cells_ / 2;
  forgetStrip(first_x_, x, true);
  forgetStrip(first_y_, y, false);
  first_x_ = x;
  first_y_ = y;
}

void RollingMap::forgetStrip(int from, int to, bool is_column)
{
  // What enters is stored where what leaves was, whichever way the square rolls.
  const int last = std::max(from, to);
  for (int k = std::max(std::min(from, to), last - cells_); k < last; ++k) {
    for (int other = 0; other < cells_; ++other) {
      const std::size_t cell = is_column ? at(k, other) : at(other, k);
      heights_[cell] = 0;
      seen_[cell] = 0;
    }
  }
}

void RollingMap::add(const Observation& observation)
{
  if (frame_ == 0) first_stamp_ = observation.stamp;
  ++frame_;
  newest_stamp_ = std::max(newest_stamp_, observation.stamp);
  if (observation.geometry.size() == 0) return;  // one of its sides may be of any length
  mark(observation);
  if (observation.may_clear) clear(observation);
}

void RollingMap::mark(const Observation& observation)
{
  const GridGeometry& grid = observation.geometry;
  const Eigen::Matrix2d rotation = observation.pose.linear();
  const SquareOverlap squares(rotation, grid.resolution, resolution_);
  const auto stamp = static_cast<float>(observation.stamp - first_stamp_);
  for (int j = 0; j < grid.cells_y; ++j) {
    for (int i = 0; i < grid.cells_x; ++i) {
      const std::uint8_t heights = observation.hit[static_cast<std::size_t>(j) * grid.cells_x + i];
      if (heights == 0) continue;
      const Eigen::Vector2d middle =
          observation.pose * Eigen::Vector2d(grid.origin_x + (i + 0.5) * grid.resolution,
                                             grid.origin_y + (j + 0.5) * grid.resolution);
      const int last_x =
          std::min(cellBelow(middle.x() + squares.reach(), resolution_), first_x_ + cells_ - 1);
      const int last_y =
          std::min(cellBelow(middle.y() + squares.reach(), resolution_), first_y_ + cells_ - 1);
      for (int y = std::max(cellBelow(middle.y() - squares.reach(), resolution_), first_y_); y <= last_y;
           ++y) {
        for (int x = std::max(cellBelow(middle.x() - squares.reach(), resolution_), first_x_); x <= last_x;
             ++x) {
          if (!squares.overlap((x + 0.5) * resolution_ - middle.x(), (y + 0.5) * resolution_ - middle.y()))
            continue;
          const std::size_t cell = at(x, y);
          heights_[cell] |= heights;
          views_[cell] = {frame_, stamp, 0, {}};
        }
      }
    }
  }
}

void RollingMap::clear(const Observation& observation)
{
  const GridGeometry& grid = observation.geometry;
  // The grid's rectangle, upright.
  Eigen::AlignedBox2d box;
  const Eigen::AlignedBox2d bounds = grid.bounds();
  for (const auto corner : {Eigen::AlignedBox2d::BottomLeft, Eigen::AlignedBox2d::BottomRight,
                            Eigen::AlignedBox2d::TopLeft, Eigen::AlignedBox2d::TopRight})
    box.extend(observation.pose * bounds.corner(corner));
  const int x0 = std::max(cellBelow(box.min().x(), resolution_), first_x_);
  const int x1 = std::min(cellBelow(box.max().x(), resolution_), first_x_ + cells_ - 1);
  const int y0 = std::max(cellBelow(box.min().y(), resolution_), first_y_);
  const int y1 = std::min(cellBelow(box.max().y(), resolution_), first_y_ + cells_ - 1);

  if (x0 > x1 || y0 > y1) return;  // beyond the square

  // From the middle of a cell to a place in the grid, in its cells.
  const Eigen::Isometry2d to_grid = observation.pose.inverse();
  const double scale = 1.0 / grid.resolution;
  const Eigen::Vector2d step = scale * resolution_ * to_grid.linear().col(0);
  for (int y = y0; y <= y1; ++y) {
    const Eigen::Vector2d first =
        scale * (to_grid * Eigen::Vector2d((x0 + 0.5) * resolution_, (y + 0.5) * resolution_) -
                 Eigen::Vector2d(grid.origin_x, grid.origin_y));
    Steps inside{0.0, static_cast<double>(x1 - x0)};
    inside.clip(first.x(), step.x(), grid.cells_x);
    inside.clip(first.y(), step.y(), grid.cells_y);
    clearRow(observation, x0, y, first, step, inside);
  }
}

void RollingMap::clearRow(const Observation& observation, int x0, int y, const Eigen::Vector2d& first,
                          const Eigen::Vector2d& step, const Steps& inside)
{
  if (!(inside.first <= inside.last)) return;  // they may be farther apart than whole numbers reach
  const int begin = static_cast<int>(std::ceil(inside.first));
  const int end = static_cast<int>(std::floor(inside.last));
  const auto columns = static_cast<std::size_t>(observation.geometry.cells_x);
  const std::size_t row = at(0, y);
  // However places that are far away have been rounded, nothing beyond the grid is read.
  const auto within = [](double place, int size) {
    return static_cast<std::size_t>(std::clamp(place, 0.0, size - 1.0));
  };
  int column = wrapped(x0 + begin);
  for (int k = begin; k <= end; ++k, column = column + 1 == cells_ ? 0 : column + 1) {
    const std::size_t i = within(first.x() + k * step.x(), observation.geometry.cells_x);
    const std::size_t j = within(first.y() + k * step.y(), observation.geometry.cells_y);
    const std::size_t from = j * columns + i;
    const bool is_floor_seen = observation.floor[from] != 0;
    const std::size_t cell = row + static_cast<std::size_t>(column);
    if (is_floor_seen) seen_[cell] = 1;
    if (heights_[cell] != 0 && views_[cell].frame != frame_)
      lookAt(cell, observation.free[from], is_floor_seen);
  }
}

void RollingMap::lookAt(std::size_t cell, std::uint8_t free, bool is_floor_seen)
{
  const auto enough = static_cast<std::uint8_t>(parameters_.clear_views);
  Views& views = views_[cell];
  if (is_floor_seen && views.floor < enough) ++views.floor;
  for (int slab = 0; slab < kSlabs; ++slab) {
    if ((free >> slab & 1) != 0 && views.looks[slab] < enough) ++views.looks[slab];
    if (views.floor >= enough && views.looks[slab] >= enough)
      heights_[cell] &= static_cast<std::uint8_t>(~(1U << slab));
  }
}

void RollingMap::forgetOld(double stamp)
{
  if (std::isinf(parameters_.remember)) return;
  const auto oldest = static_cast<float>(stamp - first_stamp_ - parameters_.remember);
  for (std::size_t cell = 0; cell < heights_.size(); ++cell) {
    if (views_[cell].stamp < oldest) heights_[cell] = 0;
  }
}

GridGeometry RollingMap::geometry() const
{
  GridGeometry geometry;
  geometry.cells_x = geometry.cells_y = cells_;
  geometry.resolution = resolution_;
  geometry.origin_x = first_x_ * resolution_;
  geometry.origin_y = first_y_ * resolution_;
  return geometry;
}

template <class Visit>
void RollingMap::visitRuns(Visit&& visit) const
{
  const auto side = static_cast<std::size_t>(cells_);
  const auto start = static_cast<std::size_t>(wrapped(first_x_));
  for (std::size_t j = 0; j < side; ++j) {
    const std::size_t row = at(0, first_y_ + static_cast<int>(j));
    visit(j * side, row + start, side - start);
    visit((j + 1) * side - start, row, start);
  }
}

void RollingMap::copyOccupied(occupancy::BinaryGrid& occupied) const
{
  occupied.reset(geometry());
  visitRuns(
      [to = occupied.row(0), from = heights_.data()](std::size_t first, std::size_t at, std::size_t count) {
        for (std::size_t k = 0; k < count; ++k) to[first + k] = from[at + k] != 0 ? 1 : 0;
      });
}

void RollingMap::copySeen(std::vector<std::uint8_t>& seen) const
{
  seen.resize(seen_.size());
  visitRuns([&](std::size_t first, std::size_t at, std::size_t count) {
    std::copy_n(seen_.data() + at, count, seen.data() + first);
  });
}

void RollingMap::copyHeights(std::vector<std::uint8_t>& heights) const
{
  heights.resize(heights_.size());
  visitRuns([&](std::size_t first, std::size_t at, std::size_t count) {
    std::copy_n(heights_.data() + at, count, heights.data() + first);
  });
}

void RollingMap::restore(const GridGeometry& geometry, const std::vector<std::uint8_t>& heights,
                         const std::vector<std::uint8_t>& seen, double stamp)
{
  reset(geometry.resolution);
  const auto nearestCell = [&](double place) { return cellBelow(place + 0.5 * resolution_, resolution_); };
  const int from_x = nearestCell(geometry.origin_x);
  const int from_y = nearestCell(geometry.origin_y);
  // The square lies in the middle of the file's.
  first_x_ = from_x + (geometry.cells_x - cells_) / 2;
  first_y_ = from_y + (geometry.cells_y - cells_) / 2;
  if (frame_ == 0) first_stamp_ = stamp;
  frame_ = std::max(frame_, 1U);
  for (int j = 0; j < geometry.cells_y; ++j) {
    for (int i = 0; i < geometry.cells_x; ++i) {
      const int x = from_x + i;
      const int y = from_y + j;
      if (x < first_x_ || x >= first_x_ + cells_ || y < first_y_ || y >= first_y_ + cells_) continue;
      const auto from = static_cast<std::size_t>(j) * static_cast<std::size_t>(geometry.cells_x) +
                        static_cast<std::size_t>(i);
      const std::size_t cell = at(x, y);
      heights_[cell] = heights[from];
      seen_[cell] = seen[from];
      views_[cell].stamp = static_cast<float>(stamp - first_stamp_);
    }
  }
}

}  // namespace polygonal_perception::mapping

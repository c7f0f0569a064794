#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/parameters/parameter_table.hpp"

namespace polygonal_perception::occupancy {

/// Size and resolution of the grid on the floor (section IV: 100 x 100 cells, 5 m ahead, 2.5 m to each side).
struct GridParameters
{
  double grid_length = 5.0;       ///< [m] ahead of the camera
  double grid_width = 5.0;        ///< [m] across, centred on the camera
  double grid_resolution = 0.05;  ///< [m] side of a cell
  double grid_behind = 0.0;       ///< [m] behind it, for sensors that look there

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor&& visit)
  {
    visit("grid_length", self.grid_length, parameters::Range{0.1, 50.0}, "m",
          "How far ahead of the camera the grid reaches.");
    visit("grid_width", self.grid_width, parameters::Range{0.1, 50.0}, "m",
          "Width of the grid, centred on the camera.");
    visit("grid_resolution", self.grid_resolution, parameters::Range{0.005, 1.0}, "m",
          "Side of a grid cell.");
    visit("grid_behind", self.grid_behind, parameters::Range{0.0, 50.0}, "m",
          "How far behind the sensor the grid reaches.");
  }
};

/// Where the cells of a grid lie in the floor frame. Cell (i, j) covers [i, i + 1) x [j, j + 1) times the
/// resolution, from (origin_x, origin_y); i counts along x (ahead), j along y (left).
struct POLYGONAL_PERCEPTION_EXPORT GridGeometry
{
  int cells_x = 0;
  int cells_y = 0;
  double resolution = 0.05;  ///< [m]
  double origin_x = 0.0;     ///< [m] corner of cell (0, 0)
  double origin_y = 0.0;     ///< [m]

  GridGeometry() = default;
  /// The fewest cells that cover what is ahead, behind and at the sides; a length that is a whole number of cells takes just that
  /// many.
  explicit GridGeometry(const GridParameters& parameters);

  std::size_t size() const { return static_cast<std::size_t>(cells_x) * static_cast<std::size_t>(cells_y); }
  /// The rectangle of all cells in the floor frame [m].
  Eigen::AlignedBox2d bounds() const
  {
    const Eigen::Vector2d low(origin_x, origin_y);
    return {low, low + resolution * Eigen::Vector2d(cells_x, cells_y)};
  }
  /// The row-major index of the cell of a place in the floor frame [m]; nothing beside the grid.
  std::optional<std::size_t> cellOf(double x, double y) const
  {
    const double i = (x - origin_x) / resolution;
    const double j = (y - origin_y) / resolution;
    // Written so that NaN fails.
    if (!(i >= 0.0 && i < cells_x && j >= 0.0 && j < cells_y)) return std::nullopt;
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(cells_x) + static_cast<std::size_t>(i);
  }
  bool operator==(const GridGeometry& other) const
  {
    return cells_x == other.cells_x && cells_y == other.cells_y && resolution == other.resolution &&
           origin_x == other.origin_x && origin_y == other.origin_y;
  }
  bool operator!=(const GridGeometry& other) const { return !(*this == other); }
};

/// A grid of cells that are occupied (1) or free (0), in the row-major order of nav_msgs/OccupancyGrid: a row
/// runs along x.
class BinaryGrid
{
public:
  BinaryGrid() = default;
  explicit BinaryGrid(const GridGeometry& geometry) { reset(geometry); }

  /// Takes on a geometry and frees every cell. Allocates only when the grid grows.
  void reset(const GridGeometry& geometry)
  {
    geometry_ = geometry;
    cells_.assign(geometry.size(), 0);
  }

  const GridGeometry& geometry() const { return geometry_; }
  int cellsX() const { return geometry_.cells_x; }
  int cellsY() const { return geometry_.cells_y; }

  bool occupied(int i, int j) const { return cells_[index(i, j)] != 0; }
  void set(int i, int j, bool occupied = true) { cells_[index(i, j)] = occupied ? 1 : 0; }

  /// The cells of row j, cellsX() of them, each 0 or 1.
  const std::uint8_t* row(int j) const { return cells_.data() + index(0, j); }
  std::uint8_t* row(int j) { return cells_.data() + index(0, j); }
  const std::vector<std::uint8_t>& cells() const { return cells_; }

  std::size_t count() const { return static_cast<std::size_t>(std::count(cells_.begin(), cells_.end(), 1)); }

private:
  std::size_t index(int i, int j) const
  {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(geometry_.cells_x) +
           static_cast<std::size_t>(i);
  }

  GridGeometry geometry_;
  std::vector<std::uint8_t> cells_;
};

}  // namespace polygonal_perception::occupancy

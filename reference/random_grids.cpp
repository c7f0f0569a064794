#include "reference/random_grids.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace polygonal_perception::reference {

namespace {

int between(int low, int high, std::mt19937& random)
{
  return std::uniform_int_distribution<int>(low, high)(random);
}

void noise(occupancy::BinaryGrid& grid, std::mt19937& random)
{
  const double density = std::uniform_real_distribution<double>(0.005, 0.95)(random);
  std::bernoulli_distribution occupied(density * density);
  for (int j = 0; j < grid.cellsY(); ++j) {
    for (int i = 0; i < grid.cellsX(); ++i) grid.set(i, j, occupied(random));
  }
}

void blobs(occupancy::BinaryGrid& grid, std::mt19937& random)
{
  for (int n = between(1, 4, random); n > 0; --n) {
    const int x = between(0, grid.cellsX() - 1, random);
    const int y = between(0, grid.cellsY() - 1, random);
    const int radius = between(1, 4, random);
    for (int j = std::max(0, y - radius); j <= std::min(grid.cellsY() - 1, y + radius); ++j) {
      for (int i = std::max(0, x - radius); i <= std::min(grid.cellsX() - 1, x + radius); ++i) {
        if ((i - x) * (i - x) + (j - y) * (j - y) <= radius * radius) grid.set(i, j);
      }
    }
  }
}

void lines(occupancy::BinaryGrid& grid, std::mt19937& random)
{
  for (int n = between(1, 3, random); n > 0; --n) {
    double x = between(0, grid.cellsX() - 1, random);
    double y = between(0, grid.cellsY() - 1, random);
    const double angle = std::uniform_real_distribution<double>(0.0, 6.28)(random);
    for (int k = 0; k < 40; ++k, x += 0.5 * std::cos(angle), y += 0.5 * std::sin(angle)) {
      const auto i = static_cast<int>(x);
      const auto j = static_cast<int>(y);
      if (x >= 0 && y >= 0 && i < grid.cellsX() && j < grid.cellsY()) grid.set(i, j);
    }
  }
}

void spiral(occupancy::BinaryGrid& grid, std::mt19937& random)
{
  const int pitch = between(2, 4, random);
  int x = 0;
  int y = 0;
  int dx = 1;
  int dy = 0;
  int length_x = grid.cellsX() - 1;
  int length_y = grid.cellsY() - 1;
  while (length_x >= 0 && length_y >= 0) {
    for (int k = dx != 0 ? length_x : length_y; k > 0; --k, x += dx, y += dy) {
      if (x >= 0 && y >= 0 && x < grid.cellsX() && y < grid.cellsY()) grid.set(x, y);
    }
    (dx != 0 ? length_x : length_y) -= pitch;
    const int turned = -dy;
    dy = dx;
    dx = turned;
  }
}

void checkerboard(occupancy::BinaryGrid& grid, std::mt19937& random)
{
  const int side = between(1, 3, random);
  for (int j = 0; j < grid.cellsY(); ++j) {
    for (int i = 0; i < grid.cellsX(); ++i) grid.set(i, j, (i / side + j / side) % 2 == 0);
  }
}

void nestedRings(occupancy::BinaryGrid& grid, std::mt19937& random)
{
  const int pitch = between(2, 5, random);
  for (int j = 0; j < grid.cellsY(); ++j) {
    for (int i = 0; i < grid.cellsX(); ++i) {
      const int depth = std::min({i, j, grid.cellsX() - 1 - i, grid.cellsY() - 1 - j});
      grid.set(i, j, depth % pitch == 0);
    }
  }
}

void singleCells(occupancy::BinaryGrid& grid, std::mt19937& random)
{
  for (int n = between(1, 3, random); n > 0; --n) {
    grid.set(between(0, grid.cellsX() - 1, random), between(0, grid.cellsY() - 1, random));
  }
}

void alongTheBorder(occupancy::BinaryGrid& grid, std::mt19937& random)
{
  std::bernoulli_distribution occupied(0.5);
  for (int i = 0; i < grid.cellsX(); ++i) {
    grid.set(i, 0, occupied(random));
    grid.set(i, grid.cellsY() - 1, occupied(random));
  }
  for (int j = 0; j < grid.cellsY(); ++j) {
    grid.set(0, j, occupied(random));
    grid.set(grid.cellsX() - 1, j, occupied(random));
  }
}

void full(occupancy::BinaryGrid& grid, std::mt19937& random)
{
  for (int j = 0; j < grid.cellsY(); ++j) {
    for (int i = 0; i < grid.cellsX(); ++i) grid.set(i, j);
  }
  if (between(0, 1, random) == 1) grid.set(grid.cellsX() / 2, grid.cellsY() / 2, false);
}

}  // namespace

occupancy::BinaryGrid randomGrid(unsigned kind, int cells_x, int cells_y, double resolution,
                                 std::mt19937& random)
{
  constexpr void (*kKinds[])(occupancy::BinaryGrid&, std::mt19937&) = {
      noise, blobs,       lines,       noise,          spiral, checkerboard,
      noise, nestedRings, singleCells, alongTheBorder, full,   blobs};
  occupancy::GridGeometry geometry;
  geometry.cells_x = cells_x;
  geometry.cells_y = cells_y;
  geometry.resolution = resolution;
  geometry.origin_y = -0.5 * cells_y * resolution;
  occupancy::BinaryGrid grid(geometry);
  kKinds[kind % std::size(kKinds)](grid, random);
  return grid;
}

std::string toText(const occupancy::BinaryGrid& grid)
{
  std::string text;
  for (int j = grid.cellsY() - 1; j >= 0; --j) {
    for (int i = 0; i < grid.cellsX(); ++i) text += grid.occupied(i, j) ? '#' : '.';
    text += '\n';
  }
  return text;
}

}  // namespace polygonal_perception::reference

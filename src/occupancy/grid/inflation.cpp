#include "polygonal_perception/occupancy/grid/inflation.hpp"

#include <cmath>

#include "polygonal_perception/occupancy/grid/bit_grid.hpp"

namespace polygonal_perception::occupancy {

// How it is done, and why: a cell's square comes within the radius of another's when the gaps between their
// columns and rows, dx = max(0, |di| - 1) and dy likewise, lie inside the disc. That kernel is exact, and
// each of its rows is one run of cells, so that 64 cells at a time are grown by shifting words. A distance
// transform is exact too, but visits every cell several times and gives distances that nobody asked for; a
// kernel in cv::dilate visits all of its cells.

Inflation::Inflation(const Parameters& parameters)
    : parameters_(parameters), occupied_(std::make_unique<BitGrid>()), grown_(std::make_unique<BitGrid>())
{
}
Inflation::Inflation(Inflation&&) noexcept = default;
Inflation& Inflation::operator=(Inflation&&) noexcept = default;
Inflation::~Inflation() = default;

void Inflation::measureDisc(double resolution)
{
  // A radius of 0.30 m is to be 6 cells of 0.05 m, though the quotient is not exactly 6.
  constexpr double kRounding = 1e-9;
  const double radius = parameters_.robot_radius / resolution;
  const double radius_squared = radius * radius * (1.0 - kRounding);
  half_widths_.assign(1, 0);
  if (radius_squared > 0.0) {
    half_widths_.clear();
    for (int gap_y = 0; gap_y * static_cast<double>(gap_y) < radius_squared; ++gap_y) {
      const double squared_width = radius_squared - gap_y * static_cast<double>(gap_y);
      const int gap_x = static_cast<int>(std::ceil(std::sqrt(squared_width))) - 1;
      half_widths_.push_back(gap_x + 1);
      if (gap_y == 0) half_widths_.push_back(gap_x + 1);  // rows 0 and 1 both have no gap
    }
  }
  disc_resolution_ = resolution;
}

void Inflation::inflate(const BinaryGrid& occupancy, BinaryGrid& inflated)
{
  const GridGeometry& geometry = occupancy.geometry();
  if (geometry.resolution != disc_resolution_) measureDisc(geometry.resolution);
  occupied_->pack(occupancy);
  grown_->grow(*occupied_, half_widths_);
  grown_->unpack(geometry, inflated);
}

}  // namespace polygonal_perception::occupancy

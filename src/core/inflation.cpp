#include "polygonal_perception/inflation.hpp"

#include <algorithm>
#include <cmath>

#include "bit_grid.hpp"

namespace polygonal_perception {

// How it is done, and why: a cell's square comes within the radius of another's when the gaps between their
// columns and rows, dx = max(0, |di| - 1) and dy likewise, lie inside the disc. That kernel is exact, and
// each of its rows is one run of cells, so that 64 cells at a time are grown by shifting words. A distance
// transform is exact too, but visits every cell several times and gives distances that nobody asked for; a
// kernel in cv::dilate visits all of its cells.

namespace {

constexpr int kMaxShift = BitGrid::kWordBits - 1;

/// words |= words moved by `shift` cells (1..63) either way
void addShifted(std::uint64_t* words, std::size_t count, int shift)
{
  const int back = BitGrid::kWordBits - shift;
  std::uint64_t previous = 0;
  for (std::size_t w = 0; w < count; ++w) {
    const std::uint64_t word = words[w];
    const std::uint64_t next = w + 1 < count ? words[w + 1] : 0;
    words[w] = word | word << shift | word >> shift | previous >> back | next << back;
    previous = word;
  }
}

/// Sets every cell within `distance` cells of one that is set. Each step may be as long as the runs that the
/// steps before it made out of single cells.
void spread(std::uint64_t* words, std::size_t count, int distance)
{
  int run = 1;
  while (distance > 0) {
    const int shift = std::min({distance, run, kMaxShift});
    addShifted(words, count, shift);
    distance -= shift;
    run += 2 * shift;
  }
}

}  // namespace

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
    for (double gap_y = 0.0; gap_y * gap_y < radius_squared; ++gap_y) {
      const int gap_x = static_cast<int>(std::ceil(std::sqrt(radius_squared - gap_y * gap_y))) - 1;
      half_widths_.push_back(gap_x + 1);
      if (gap_y == 0.0) half_widths_.push_back(gap_x + 1);  // rows 0 and 1 both have no gap
    }
  }
  disc_resolution_ = resolution;
}

void Inflation::inflate(const BinaryGrid& occupancy, BinaryGrid& inflated)
{
  const GridGeometry& geometry = occupancy.geometry();
  if (geometry.resolution != disc_resolution_) measureDisc(geometry.resolution);
  occupied_->pack(occupancy);
  grown_->reset(geometry.cells_x, geometry.cells_y);

  const std::size_t words = grown_->wordsPerRow();
  const std::uint64_t in_last_word = (std::uint64_t{1} << (geometry.cells_x % BitGrid::kWordBits)) - 1;
  const int reach = static_cast<int>(half_widths_.size()) - 1;
  for (int j = 0; j < geometry.cells_y; ++j) {
    std::uint64_t* row = grown_->row(j);
    // From the disc's middle outwards: what came in earlier is spread further.
    for (int d = 0; d <= reach; ++d) {
      for (const int source : {j - d, j + d}) {
        if (source < 0 || source >= geometry.cells_y) continue;
        const std::uint64_t* from = occupied_->row(source);
        for (std::size_t w = 0; w < words; ++w) row[w] |= from[w];
      }
      const int next_half_width = d < reach ? half_widths_[static_cast<std::size_t>(d) + 1] : 0;
      spread(row, words, half_widths_[static_cast<std::size_t>(d)] - next_half_width);
    }
    row[words - 1] &= in_last_word;
  }
  grown_->unpack(geometry, inflated);
}

}  // namespace polygonal_perception

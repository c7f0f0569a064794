#include "occupancy/polygons/proximity.hpp"

#include <algorithm>
#include <cmath>

namespace polygonal_perception::occupancy {

namespace {

constexpr int kMaxHalvings = 8;
/// With this many fractional bits every halving is exact.
constexpr int kFractionBits = kMaxHalvings;
constexpr std::int32_t kOne = 1 << kFractionBits;
constexpr int kCellBits = kFractionBits + 6;
static_assert(kUnitsPerCell == 1 << 6, "a cell is a power of two");

constexpr std::int64_t kSquaredCell = std::int64_t{1} << (2 * kCellBits);
/// Larger triangles are halved before a cell is looked for that is near to all of it; smaller ones are not
/// halved. Measured on the recorded frames: the loss of vertices is below 1 %, the time half of that for
/// halving to the end.
constexpr std::int64_t kLargeSquared = 6 * kSquaredCell;
constexpr std::int64_t kSmallSquared = 3 * kSquaredCell;

/// The first cell of the row that is set, from `first` to `last` (both included); last + 1 or more if there
/// is none.
int firstSet(const std::uint64_t* row, int first, int last)
{
  int w = first / BitGrid::kWordBits;
  std::uint64_t word = row[w] & ~std::uint64_t{0} << (first % BitGrid::kWordBits);
  while (word == 0 && ++w <= last / BitGrid::kWordBits) word = row[w];
  return word == 0 ? last + 1 : w * BitGrid::kWordBits + __builtin_ctzll(word);
}

/// Of a disc, at a height above its centre.
int halfWidth(double radius, double height)
{
  return static_cast<int>(std::sqrt(radius * radius - height * height));
}

}  // namespace

/// A point with kFractionBits more bits than the lattice.
struct Proximity::Corner
{
  /// How far row j is above or below the point, in units, rounded up.
  std::size_t gapToRow(int j) const
  {
    const std::int32_t gap = std::max({0, (j << kCellBits) - y, y - ((j + 1) << kCellBits)});
    return static_cast<std::size_t>((gap + kOne - 1) >> kFractionBits);
  }

  std::int64_t squaredDistance(const Corner& other) const
  {
    const std::int64_t dx = x - other.x;
    const std::int64_t dy = y - other.y;
    return dx * dx + dy * dy;
  }

  std::int32_t x;
  std::int32_t y;
};

void Proximity::setLimit(double limit, double margin)
{
  if (limit == limit_ && margin == margin_) return;
  limit_ = limit;
  margin_ = margin;
  const double units = limit * kUnitsPerCell;
  half_widths_.clear();
  for (int gap = 0; gap <= units; ++gap) half_widths_.push_back(halfWidth(units, gap));
  margin_half_widths_.clear();
  for (int rows = 0; rows <= margin; ++rows) margin_half_widths_.push_back(halfWidth(margin, rows));
}

void Proximity::setCells(const BitGrid& occupied, const BitGrid& covered)
{
  occupied_ = &occupied;
  inside_.grow(covered, margin_half_widths_);
  witness_i_ = -1;
}

bool Proximity::isInside(const Triangle& triangle) const
{
  const auto& [a, b, c] = triangle;
  const int first_i = std::min({a.x, b.x, c.x}) >> kCellBits;
  const int last_i = (std::max({a.x, b.x, c.x}) - 1) >> kCellBits;
  if (first_i / BitGrid::kWordBits != last_i / BitGrid::kWordBits) return false;
  const int first_j = std::min({a.y, b.y, c.y}) >> kCellBits;
  const int last_j = (std::max({a.y, b.y, c.y}) - 1) >> kCellBits;
  const std::uint64_t columns = ~std::uint64_t{0} >> (BitGrid::kWordBits - 1 - (last_i - first_i))
                                                         << (first_i % BitGrid::kWordBits);
  for (int j = first_j; j <= last_j; ++j) {
    if ((columns & ~inside_.row(j)[first_i / BitGrid::kWordBits]) != 0) return false;
  }
  return true;
}

bool Proximity::isNearWitness(const Triangle& triangle) const
{
  return witness_i_ >= 0 && std::all_of(triangle.begin(), triangle.end(), [this](const Corner& corner) {
           const std::size_t gap = corner.gapToRow(witness_j_);
           if (gap >= half_widths_.size()) return false;
           const std::int32_t half_width = half_widths_[gap] * kOne;
           return (witness_i_ << kCellBits) - corner.x <= half_width &&
                  corner.x - ((witness_i_ + 1) << kCellBits) <= half_width;
         });
}

/// Looks for an occupied cell that is near to all three corners.
bool Proximity::findWitness(const Triangle& triangle)
{
  const auto& [a, b, c] = triangle;
  const std::int32_t reach = (static_cast<std::int32_t>(half_widths_.size()) - 1) * kOne;
  // Cells of which the far side is at least at `low`, the near side at most at `high`.
  const auto firstCell = [](std::int32_t low) { return -(-low >> kCellBits) - 1; };
  const auto lastCell = [](std::int32_t high) { return high >> kCellBits; };
  const int first_j = std::max(0, firstCell(std::max({a.y, b.y, c.y}) - reach));
  const int last_j = std::min(occupied_->cellsY() - 1, lastCell(std::min({a.y, b.y, c.y}) + reach));
  const int first_i = std::max(0, firstCell(std::max({a.x, b.x, c.x}) - reach));
  const int last_i = std::min(occupied_->cellsX() - 1, lastCell(std::min({a.x, b.x, c.x}) + reach));
  if (first_i > last_i) return false;
  for (int j = first_j; j <= last_j; ++j) {
    // Most rows are empty here.
    int first = firstSet(occupied_->row(j), first_i, last_i);
    int last = last_i;
    if (first > last) continue;
    for (const Corner& corner : triangle) {
      const std::int32_t half_width = half_widths_[corner.gapToRow(j)] * kOne;
      first = std::max(first, firstCell(corner.x - half_width));
      last = std::min(last, lastCell(corner.x + half_width));
    }
    if (first > last) continue;
    const int found = firstSet(occupied_->row(j), first, last);
    if (found <= last) {
      witness_i_ = found;
      witness_j_ = j;
      return true;
    }
  }
  return false;
}

bool Proximity::covers(const Triangle& triangle, int halvings)
{
  if (isInside(triangle) || isNearWitness(triangle)) return true;
  const auto& [a, b, c] = triangle;
  const std::int64_t ab = a.squaredDistance(b);
  const std::int64_t bc = b.squaredDistance(c);
  const std::int64_t ca = c.squaredDistance(a);
  const std::int64_t longest = std::max({ab, bc, ca});
  if (longest < kLargeSquared && findWitness(triangle)) return true;
  if (halvings == 0 || longest < kSmallSquared) return false;
  if (longest == bc) return coversHalves({b, c, a}, halvings - 1);
  if (longest == ca) return coversHalves({c, a, b}, halvings - 1);
  return coversHalves(triangle, halvings - 1);
}

bool Proximity::coversHalves(const Triangle& triangle, int halvings)
{
  const auto& [a, b, c] = triangle;
  const Corner middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
  return covers({a, middle, c}, halvings) && covers({middle, b, c}, halvings);
}

bool Proximity::covers(LatticePoint a, LatticePoint b, LatticePoint c)
{
  if (cross(a, b, c) == 0) return true;
  const auto corner = [](LatticePoint point) { return Corner{point.x * kOne, point.y * kOne}; };
  return covers({corner(a), corner(b), corner(c)}, kMaxHalvings);
}

}  // namespace polygonal_perception::occupancy

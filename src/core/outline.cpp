#include "outline.hpp"

namespace polygonal_perception {

// A sweep over the grid's rows. Where the cells on both sides of a line between two rows differ there is a
// piece of outline; its ends are corners. Corners of a line are joined in pairs along it, and each to the
// next corner below or above it in its column. The work is a word operation for 64 cells, and a few steps for
// each corner.

namespace {

int lowestBit(std::uint64_t word)
{
  return __builtin_ctzll(word);
}
int highestBit(std::uint64_t word)
{
  return BitGrid::kWordBits - 1 - __builtin_clzll(word);
}

/// The column at which the run of cells that holds cell i begins.
int runStart(const std::uint64_t* row, int i)
{
  int w = i / BitGrid::kWordBits;
  const int shift = BitGrid::kWordBits - 1 - i % BitGrid::kWordBits;
  std::uint64_t free = ~row[w] << shift >> shift;
  while (free == 0 && w > 0) free = ~row[--w];
  return free == 0 ? 0 : w * BitGrid::kWordBits + highestBit(free) + 1;
}

void join(Outlines& outlines, std::uint32_t from, std::uint32_t to)
{
  outlines.vertices[from].next = to;
  outlines.vertices[to].previous = from;
}

}  // namespace

void OutlineTracer::sweepRow(const BitGrid& cells, int y, Outlines& outlines)
{
  const std::uint64_t* const below = y > 0 ? cells.row(y - 1) : outside_.data();
  const std::uint64_t* const above = y < cells.cellsY() ? cells.row(y) : outside_.data();
  std::uint32_t open_left = Outlines::kNone;

  const auto add = [&](std::int32_t x_units, std::int32_t y_units) {
    const auto added = static_cast<std::uint32_t>(outlines.vertices.size());
    outlines.vertices.push_back({x_units, y_units, Outlines::kNone, Outlines::kNone});
    left_of_.push_back(Outlines::kNone);
    return added;
  };
  // Solid ground lies to the left of an edge: above one that runs along x, before one that runs along y.
  const auto closeLeft = [&](std::uint32_t vertex, bool solid_above) {
    solid_above ? join(outlines, open_left, vertex) : join(outlines, vertex, open_left);
  };
  const auto closeBelow = [&](std::uint32_t vertex, int x, bool solid_before) {
    const std::uint32_t lower = open_below_[static_cast<std::size_t>(x)];
    solid_before ? join(outlines, lower, vertex) : join(outlines, vertex, lower);
  };

  std::uint64_t below_carry = 0;
  std::uint64_t above_carry = 0;
  for (std::size_t w = 0; w < cells.wordsPerRow(); ++w) {
    // Bit x of each mask tells of the point between cells x - 1 and x: is there outline to its right, left,
    // up, down?
    const std::uint64_t below_before = below[w] << 1 | below_carry;
    const std::uint64_t above_before = above[w] << 1 | above_carry;
    below_carry = below[w] >> (BitGrid::kWordBits - 1);
    above_carry = above[w] >> (BitGrid::kWordBits - 1);
    const std::uint64_t right = below[w] ^ above[w];
    const std::uint64_t left = below_before ^ above_before;
    const std::uint64_t up = above[w] ^ above_before;
    const std::uint64_t crossings = right & left & up;
    std::uint64_t corners = (right ^ left) | crossings;
    for (; corners != 0; corners &= corners - 1) {
      const int b = lowestBit(corners);
      const int x = static_cast<int>(w) * BitGrid::kWordBits + b;
      const bool solid_before_below = (below_before >> b & 1U) != 0;
      const bool solid_before_above = (above_before >> b & 1U) != 0;
      if ((crossings >> b & 1U) != 0) {
        // The first vertex goes round the free cell before x, the second round the one behind it.
        const bool free_before_is_above = solid_before_below;
        const std::int32_t lift = free_before_is_above ? Outlines::kParting : -Outlines::kParting;
        const std::uint32_t before = add(x * kUnitsPerCell - Outlines::kParting, y * kUnitsPerCell + lift);
        const std::uint32_t behind = add(x * kUnitsPerCell + Outlines::kParting, y * kUnitsPerCell - lift);
        closeLeft(before, solid_before_above);
        open_left = behind;
        closeBelow(free_before_is_above ? behind : before, x, solid_before_below);
        open_below_[static_cast<std::size_t>(x)] = free_before_is_above ? before : behind;
        if (!free_before_is_above) {
          left_of_[behind] = open_below_[static_cast<std::size_t>(runStart(above, x - 1))];
        }
        continue;
      }
      const std::uint32_t corner = add(x * kUnitsPerCell, y * kUnitsPerCell);
      const bool goes_right = (right >> b & 1U) != 0;
      const bool goes_up = (up >> b & 1U) != 0;
      if (goes_right) {
        open_left = corner;
      } else {
        closeLeft(corner, solid_before_above);
      }
      if (goes_up) {
        open_below_[static_cast<std::size_t>(x)] = corner;
      } else {
        closeBelow(corner, x, solid_before_below);
      }
      if (goes_right && goes_up && solid_before_above) {
        left_of_[corner] = open_below_[static_cast<std::size_t>(runStart(above, x - 1))];
      }
    }
  }
}

void OutlineTracer::collectRings(Outlines& outlines)
{
  ring_of_.assign(outlines.vertices.size(), Outlines::kNone);
  for (std::uint32_t start = 0; start < outlines.vertices.size(); ++start) {
    if (ring_of_[start] != Outlines::kNone) continue;
    const auto ring = static_cast<std::uint32_t>(outlines.rings.size());
    outlines.rings.push_back({start, 0, Outlines::kNone});
    std::uint32_t vertex = start;
    do {
      ring_of_[vertex] = ring;
      ++outlines.rings[ring].size;
      vertex = outlines.vertices[vertex].next;
    } while (vertex != start);
    // A ring's first vertex is the leftmost of its lowest ones. If that one turns right, the free space
    // inside starts here, and to the left, behind cells of the same component, is an outline that was met
    // earlier.
    if (left_of_[start] != Outlines::kNone) {
      const std::uint32_t neighbour = ring_of_[left_of_[start]];
      const std::uint32_t its_parent = outlines.rings[neighbour].parent;
      outlines.rings[ring].parent = its_parent == Outlines::kNone ? neighbour : its_parent;
    }
  }
}

void OutlineTracer::trace(const BitGrid& cells, Outlines& outlines)
{
  outlines.vertices.clear();
  outlines.rings.clear();
  left_of_.clear();
  outside_.assign(cells.wordsPerRow(), 0);
  open_below_.assign(static_cast<std::size_t>(cells.cellsX()) + 1, Outlines::kNone);
  for (int y = 0; y <= cells.cellsY(); ++y) sweepRow(cells, y, outlines);
  collectRings(outlines);
}

}  // namespace polygonal_perception

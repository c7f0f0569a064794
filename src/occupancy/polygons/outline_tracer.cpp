#include "polygonal_perception/occupancy/polygons/outline_tracer.hpp"

namespace polygonal_perception::occupancy {

// A sweep over the lines between the grid's rows. Where the cells below and above a line differ there is a
// piece of outline; its ends are corners. Corners of a line are joined in pairs along it, and each to the
// next corner below or above it in its column. The work is a word operation for 64 cells, and a few steps for
// each corner.

namespace {

/// The four cells round a point of the lattice, as bits.
constexpr std::uint32_t kBelowBefore = 1;
constexpr std::uint32_t kBelowBehind = 2;
constexpr std::uint32_t kAboveBefore = 4;
constexpr std::uint32_t kAboveBehind = 8;

int lowestBit(std::uint64_t word)
{
  return __builtin_ctzll(word);
}
int highestBit(std::uint64_t word)
{
  return BitGrid::kWordBits - 1 - __builtin_clzll(word);
}

void join(std::uint32_t from, std::uint32_t to, Outlines& outlines)
{
  outlines.vertices[from].next = to;
  outlines.vertices[to].previous = from;
}

}  // namespace

/// A line between two rows of cells.
struct OutlineTracer::Line
{
  const std::uint64_t* below;
  const std::uint64_t* above;
  std::size_t words;
  std::int32_t y;
};

std::uint32_t OutlineTracer::addVertex(LatticePoint at, Outlines& outlines)
{
  const auto added = static_cast<std::uint32_t>(outlines.vertices.size());
  outlines.vertices.push_back({at, Outlines::kNone, Outlines::kNone});
  before_.push_back(Outlines::kNone);
  return added;
}

// Solid ground lies to the left of an edge: above one that runs along x, before one that runs along y.

void OutlineTracer::closeBefore(std::uint32_t vertex, bool solid_above, Outlines& outlines) const
{
  solid_above ? join(open_before_, vertex, outlines) : join(vertex, open_before_, outlines);
}

void OutlineTracer::closeBelow(std::uint32_t vertex, int x, bool solid_before, Outlines& outlines)
{
  const std::uint32_t lower = open_below_[static_cast<std::size_t>(x)];
  solid_before ? join(lower, vertex, outlines) : join(vertex, lower, outlines);
}

/// The outline that is met first on the way along -x through the row above, from the point at x.
std::uint32_t OutlineTracer::outlineBefore(const Line& line, int x) const
{
  if (x == 0) return Outlines::kNone;
  const int last = x - 1;
  int w = last / BitGrid::kWordBits;
  const std::uint64_t like_last =
      (line.above[w] >> (last % BitGrid::kWordBits) & 1U) != 0 ? ~std::uint64_t{0} : 0;
  const int shift = BitGrid::kWordBits - 1 - last % BitGrid::kWordBits;
  std::uint64_t other = (line.above[w] ^ like_last) << shift >> shift;
  while (other == 0 && w > 0) other = line.above[--w] ^ like_last;
  // The grid's border is an outline only to solid ground.
  if (other == 0) return like_last != 0 ? open_below_[0] : Outlines::kNone;
  const int x_before = w * BitGrid::kWordBits + highestBit(other) + 1;
  return open_below_[static_cast<std::size_t>(x_before)];
}

void OutlineTracer::addCorner(const Line& line, int x, std::uint32_t surroundings, Outlines& outlines)
{
  const std::uint32_t corner = addVertex({x * kUnitsPerCell, line.y * kUnitsPerCell}, outlines);
  const auto solid = [surroundings](std::uint32_t cell) { return (surroundings & cell) != 0; };
  const bool goes_behind = solid(kBelowBehind) != solid(kAboveBehind);
  const bool goes_up = solid(kAboveBefore) != solid(kAboveBehind);
  if (goes_behind) {
    open_before_ = corner;
  } else {
    closeBefore(corner, solid(kAboveBefore), outlines);
  }
  if (goes_up) {
    open_below_[static_cast<std::size_t>(x)] = corner;
  } else {
    closeBelow(corner, x, solid(kBelowBefore), outlines);
  }
  if (goes_behind && goes_up) before_[corner] = outlineBefore(line, x);
}

/// Two cells that meet in a corner only: one vertex goes round the free cell before it, the other round the
/// one behind.
void OutlineTracer::addCrossing(const Line& line, int x, std::uint32_t surroundings, Outlines& outlines)
{
  const bool free_before_is_above = (surroundings & kBelowBefore) != 0;
  const LatticePoint corner{x * kUnitsPerCell, line.y * kUnitsPerCell};
  const std::int32_t lift = free_before_is_above ? Outlines::kCornerGap : -Outlines::kCornerGap;
  const std::uint32_t before = addVertex({corner.x - Outlines::kCornerGap, corner.y + lift}, outlines);
  const std::uint32_t behind = addVertex({corner.x + Outlines::kCornerGap, corner.y - lift}, outlines);
  closeBefore(before, !free_before_is_above, outlines);
  open_before_ = behind;
  closeBelow(free_before_is_above ? behind : before, x, free_before_is_above, outlines);
  open_below_[static_cast<std::size_t>(x)] = free_before_is_above ? before : behind;
  if (!free_before_is_above) before_[behind] = outlineBefore(line, x);
}

void OutlineTracer::sweepLine(const Line& line, Outlines& outlines)
{
  std::uint64_t below_carry = 0;
  std::uint64_t above_carry = 0;
  for (std::size_t w = 0; w < line.words; ++w) {
    // Bit x of each mask tells of the point between cells x - 1 and x.
    const std::uint64_t below_before = line.below[w] << 1 | below_carry;
    const std::uint64_t above_before = line.above[w] << 1 | above_carry;
    below_carry = line.below[w] >> (BitGrid::kWordBits - 1);
    above_carry = line.above[w] >> (BitGrid::kWordBits - 1);
    const std::uint64_t edge_before = below_before ^ above_before;
    const std::uint64_t edge_behind = line.below[w] ^ line.above[w];
    const std::uint64_t crossings = edge_before & edge_behind & (line.above[w] ^ above_before);
    for (std::uint64_t rest = (edge_before ^ edge_behind) | crossings; rest != 0; rest &= rest - 1) {
      const int bit = lowestBit(rest);
      const int x = static_cast<int>(w) * BitGrid::kWordBits + bit;
      const auto surroundings = static_cast<std::uint32_t>(
          (below_before >> bit & 1U) * kBelowBefore + (line.below[w] >> bit & 1U) * kBelowBehind +
          (above_before >> bit & 1U) * kAboveBefore + (line.above[w] >> bit & 1U) * kAboveBehind);
      if ((crossings >> bit & 1U) != 0) {
        addCrossing(line, x, surroundings, outlines);
      } else {
        addCorner(line, x, surroundings, outlines);
      }
    }
  }
}

void OutlineTracer::collectRings(Outlines& outlines)
{
  std::vector<Outlines::Ring>& rings = outlines.rings;
  ring_of_.assign(outlines.vertices.size(), Outlines::kNone);
  for (std::uint32_t start = 0; start < outlines.vertices.size(); ++start) {
    if (ring_of_[start] != Outlines::kNone) continue;
    Outlines::Ring ring;
    ring.start = start;
    std::uint32_t vertex = start;
    do {
      ring_of_[vertex] = static_cast<std::uint32_t>(rings.size());
      ++ring.size;
      vertex = outlines.vertices[vertex].next;
    } while (vertex != start);

    // The start is the leftmost of the ring's lowest vertices: a boundary leaves it along x, a hole along y.
    const std::uint32_t second = outlines.vertices[start].next;
    ring.hole = outlines.vertices[second].at.x - outlines.vertices[start].at.x < kUnitsPerCell / 2;
    // The outline before the start was met earlier. It bounds the same component if this is a hole, the same
    // free space if this is a boundary; so either that outline is the parent, or both have the same one.
    if (before_[start] != Outlines::kNone) {
      const std::uint32_t neighbour = ring_of_[before_[start]];
      ring.parent = rings[neighbour].hole != ring.hole ? neighbour : rings[neighbour].parent;
      if (ring.parent != Outlines::kNone) rings[ring.parent].has_nested_ring = true;
    }
    rings.push_back(ring);
  }
}

void OutlineTracer::trace(const BitGrid& cells, Outlines& outlines)
{
  outlines.vertices.clear();
  outlines.rings.clear();
  before_.clear();
  outside_.assign(cells.wordsPerRow(), 0);
  open_below_.assign(static_cast<std::size_t>(cells.cellsX()) + 1, Outlines::kNone);
  for (std::int32_t y = 0; y <= cells.cellsY(); ++y) {
    sweepLine({y > 0 ? cells.row(y - 1) : outside_.data(),
               y < cells.cellsY() ? cells.row(y) : outside_.data(), cells.wordsPerRow(), y},
              outlines);
  }
  collectRings(outlines);
}

}  // namespace polygonal_perception::occupancy

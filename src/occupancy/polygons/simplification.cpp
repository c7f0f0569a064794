#include "occupancy/polygons/simplification.hpp"

namespace polygonal_perception::occupancy {

namespace {

constexpr std::int64_t kTwiceACell = std::int64_t{2} * kUnitsPerCell * kUnitsPerCell;
/// Rising thresholds come near enough to the order of costs, and need no heap.
constexpr int kDoublings = 2;
/// Where there are too many vertices the threshold rises in so many steps, ...
constexpr int kRises = 12;
/// ... each by the first threshold over this.
constexpr int kRisesToDouble = 3;

}  // namespace

void Simplification::reduce(Outlines::Ring& ring, std::int64_t max_cost, std::size_t enough)
{
  std::uint32_t vertex = ring.start;
  for (std::uint32_t visited = 0; visited < ring.size && ring.size > 3 && vertices_ > enough;) {
    if (reduction_.cost(vertex) <= max_cost && reduction_.removeVertex(vertex, ring, vertex)) {
      visited = 0;
      --vertices_;
    } else {
      vertex = reduction_.next(vertex);
      ++visited;
    }
  }
}

void Simplification::simplify(int cells_x, int cells_y, double max_added_area, std::size_t enough,
                              Proximity& proximity, Outlines& outlines)
{
  reduction_.start(cells_x, cells_y, proximity, outlines);
  const auto max_cost = static_cast<std::int64_t>(max_added_area * kTwiceACell);
  vertices_ = 0;
  for (const Outlines::Ring& ring : outlines.rings) vertices_ += ring.size;
  for (Outlines::Ring& ring : outlines.rings) {
    for (int n = kDoublings; n >= 0; --n) reduce(ring, max_cost >> n, 0);
    if (!ring.hole || ring.has_nested_ring) continue;
    const std::size_t size = ring.size;
    if (reduction_.fillHole(ring, max_cost)) vertices_ -= size;
  }
  for (int n = 1; n <= kRises && vertices_ > enough; ++n) {
    for (Outlines::Ring& ring : outlines.rings)
      reduce(ring, max_cost + n * max_cost / kRisesToDouble, enough);
  }
}

}  // namespace polygonal_perception::occupancy

#include "occupancy/polygons/outline_reduction.hpp"

#include <algorithm>
#include <cmath>

namespace polygonal_perception::occupancy {

namespace {

struct Vector
{
  Vector(LatticePoint from, LatticePoint to) : x(to.x - from.x), y(to.y - from.y) {}
  std::int64_t x;
  std::int64_t y;
};

std::int64_t cross(Vector a, Vector b)
{
  return a.x * b.y - a.y * b.x;
}

}  // namespace

/// Of an inward or straight vertex, what cutting it off adds; of an outward one, what replacing the edge that
/// leaves it adds. The triangle over the edge b -> c has the sides' directions from a -> b and c -> d.
std::int64_t OutlineReduction::costOf(std::uint32_t vertex) const
{
  const LatticePoint a = at(previous(vertex));
  const LatticePoint b = at(vertex);
  const LatticePoint c = at(next(vertex));
  const std::int64_t turn = cross(a, b, c);
  if (turn <= 0) return -turn;
  const LatticePoint d = at(next(next(vertex)));
  const std::int64_t next_turn = cross(b, c, d);
  const std::int64_t whole_turn = cross(Vector(a, b), Vector(c, d));
  if (next_turn <= 0 || whole_turn <= 0) return kNever;
  const double area =
      static_cast<double>(turn) * static_cast<double>(next_turn) / static_cast<double>(whole_turn);
  return area < 1e18 ? static_cast<std::int64_t>(area) : kNever;
}

/// The costs of the vertices from `first` to `last`.
void OutlineReduction::updateCosts(std::uint32_t first, std::uint32_t last)
{
  for (std::uint32_t v = first;; v = next(v)) {
    costs_[v] = costOf(v);
    if (v == last) return;
  }
}

bool OutlineReduction::isAllowed(const EdgeIndex::Change& change)
{
  for (std::size_t n = 0; n < change.triangle_count; ++n) {
    const auto& [a, b, c] = change.triangles[n];
    if (!proximity_->covers(a, b, c)) return false;
  }
  return edges_.isClear(change, *outlines_);
}

bool OutlineReduction::cutOff(std::uint32_t vertex, Outlines::Ring& ring)
{
  const std::uint32_t a = previous(vertex);
  const std::uint32_t c = next(vertex);
  EdgeIndex::Change change;
  change.first = a;
  change.last = c;
  change.add(at(a), at(vertex), at(c));
  if (!isAllowed(change)) return false;
  outlines_->remove(vertex, ring);
  edges_.add(a, *outlines_);
  updateCosts(previous(a), c);
  return true;
}

bool OutlineReduction::isInGrid(LatticePoint point) const
{
  return point.x >= 0 && point.y >= 0 && point.x <= grid_corner_.x && point.y <= grid_corner_.y;
}

/// The point of the lattice near to where the lines a -> b and d -> c meet, such that the way a, point, d
/// leaves b and c on the inner side.
bool OutlineReduction::meetOutside(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d,
                                   LatticePoint& meeting) const
{
  const Vector ab(a, b);
  const Vector cd(c, d);
  const double along = static_cast<double>(cross(Vector(b, c), cd)) / static_cast<double>(cross(ab, cd));
  const double x = std::floor(b.x + along * static_cast<double>(ab.x));
  const double y = std::floor(b.y + along * static_cast<double>(ab.y));
  if (!(x >= -1.0 && y >= -1.0 && x <= grid_corner_.x && y <= grid_corner_.y)) return false;
  std::int64_t least = kNever;
  for (const std::int32_t offset_y : {0, 1}) {
    for (const std::int32_t offset_x : {0, 1}) {
      const LatticePoint q{static_cast<std::int32_t>(x) + offset_x, static_cast<std::int32_t>(y) + offset_y};
      if (!isInGrid(q) || cross(a, q, b) < 0 || cross(q, d, c) < 0) continue;
      const std::int64_t area = cross(a, q, d);
      if (area >= least) continue;
      least = area;
      meeting = q;
    }
  }
  return least != kNever;
}

/// Puts a vertex behind another one.
std::uint32_t OutlineReduction::insert(LatticePoint point, std::uint32_t previous, Outlines::Ring& ring)
{
  const auto added = static_cast<std::uint32_t>(outlines_->vertices.size());
  const std::uint32_t following = next(previous);
  outlines_->vertices.push_back({point, previous, following});
  outlines_->vertices[previous].next = added;
  outlines_->vertices[following].previous = added;
  costs_.push_back(kNever);
  ++ring.size;
  return added;
}

bool OutlineReduction::extendNeighbours(std::uint32_t vertex, Outlines::Ring& ring)
{
  const std::uint32_t a = previous(vertex);
  const std::uint32_t b = vertex;
  const std::uint32_t c = next(b);
  const std::uint32_t d = next(c);
  LatticePoint q;
  if (!meetOutside(at(a), at(b), at(c), at(d), q)) return false;
  EdgeIndex::Change change;
  change.first = a;
  change.last = d;
  change.add(at(b), q, at(c));
  // What rounding to the lattice adds along the two neighbours.
  change.add(at(a), q, at(b));
  change.add(at(c), q, at(d));
  if (!isAllowed(change)) return false;

  const std::uint32_t added = insert(q, a, ring);
  outlines_->remove(b, ring);
  outlines_->remove(c, ring);
  edges_.add(a, *outlines_);
  edges_.add(added, *outlines_);
  updateCosts(previous(a), d);
  return true;
}

bool OutlineReduction::removeVertex(std::uint32_t vertex, Outlines::Ring& ring, std::uint32_t& resume)
{
  const std::uint32_t before = previous(previous(vertex));
  const bool inward = cross(at(previous(vertex)), at(vertex), at(next(vertex))) <= 0;
  const bool removed = inward ? cutOff(vertex, ring) : extendNeighbours(vertex, ring);
  // What is in the way stays there, as nothing ever shrinks: no need to try again before the neighbours
  // change.
  if (!removed) costs_[vertex] = kNever;
  if (removed) resume = before;
  return removed;
}

bool OutlineReduction::fillHole(Outlines::Ring& hole, std::int64_t max_cost)
{
  const LatticePoint fan = at(hole.start);
  std::int64_t area = 0;
  for (std::uint32_t v = next(hole.start); next(v) != hole.start; v = next(v))
    area += cross(fan, at(next(v)), at(v));
  if (area > max_cost * hole.size) return false;
  for (std::uint32_t v = next(hole.start); next(v) != hole.start; v = next(v)) {
    if (!proximity_->covers(fan, at(v), at(next(v)))) return false;
  }
  while (hole.size > 0) outlines_->remove(hole.start, hole);
  return true;
}

void OutlineReduction::start(int cells_x, int cells_y, Proximity& proximity, Outlines& outlines)
{
  outlines_ = &outlines;
  proximity_ = &proximity;
  grid_corner_ = {cells_x * kUnitsPerCell, cells_y * kUnitsPerCell};
  edges_.build(cells_x, cells_y, outlines);
  costs_.resize(outlines.vertices.size());
  for (const Outlines::Ring& ring : outlines.rings) updateCosts(ring.start, previous(ring.start));
}

}  // namespace polygonal_perception::occupancy

#include "occupancy/polygons/edge_index.hpp"

#include <algorithm>
#include <cstdlib>

namespace polygonal_perception::occupancy {

namespace {

constexpr std::int32_t kBucketSide = 8 * kUnitsPerCell;
constexpr std::int32_t kClearance = EdgeIndex::kClearance;

using Triangle = EdgeIndex::Triangle;

/// Twice the least area that a triangle over the edge a -> b has if its third corner keeps the clearance from
/// the edge's line. The length is taken from above, so that no root is needed.
std::int64_t clearArea(LatticePoint a, LatticePoint b)
{
  return static_cast<std::int64_t>(kClearance) * (std::abs(b.x - a.x) + std::abs(b.y - a.y));
}

/// Does a line along one of the triangle's sides, or along the edge, part the two?
bool separatedByALine(const Triangle& triangle, LatticePoint from, LatticePoint to)
{
  for (std::size_t n = 0; n < 3; ++n) {
    const LatticePoint a = triangle[n];
    const LatticePoint b = triangle[(n + 1) % 3];
    const std::int64_t clear = clearArea(a, b);
    if (-cross(a, b, from) >= clear && -cross(a, b, to) >= clear) return true;
  }
  const std::int64_t clear = clearArea(from, to);
  const std::int64_t a = cross(from, to, triangle[0]);
  const std::int64_t b = cross(from, to, triangle[1]);
  const std::int64_t c = cross(from, to, triangle[2]);
  return std::min({a, b, c}) >= clear || std::max({a, b, c}) <= -clear;
}

/// Does the point keep the clearance from the segment?
bool keepsOff(LatticePoint point, LatticePoint a, LatticePoint b)
{
  constexpr std::int64_t kSquare = std::int64_t{kClearance} * kClearance;
  if (dot(a, b, point) <= 0) return dot(a, point, point) >= kSquare;
  if (dot(b, a, point) <= 0) return dot(b, point, point) >= kSquare;
  return std::abs(cross(a, b, point)) >= clearArea(a, b);
}

/// For an edge that ends in a corner of the triangle: does it come from outside, and keep off but for that
/// corner?
bool fansOut(const Triangle& triangle, LatticePoint shared, LatticePoint end)
{
  for (std::size_t n = 0; n < 3; ++n) {
    if (!(triangle[n] == shared)) continue;
    const LatticePoint b = triangle[(n + 1) % 3];
    const LatticePoint c = triangle[(n + 2) % 3];
    const bool between = cross(shared, b, end) >= 0 && cross(shared, end, c) >= 0;
    return !between && keepsOff(end, shared, b) && keepsOff(end, shared, c) && keepsOff(b, shared, end) &&
           keepsOff(c, shared, end);
  }
  return separatedByALine(triangle, shared, end);
}

/// The bounding box of a change.
class Box
{
public:
  void include(LatticePoint point)
  {
    low_ = {std::min(low_.x, point.x), std::min(low_.y, point.y)};
    high_ = {std::max(high_.x, point.x), std::max(high_.y, point.y)};
  }
  void growBy(std::int32_t distance)
  {
    low_ = {low_.x - distance, low_.y - distance};
    high_ = {high_.x + distance, high_.y + distance};
  }
  bool overlapsBoxOf(LatticePoint a, LatticePoint b) const
  {
    return std::max(a.x, b.x) >= low_.x && std::min(a.x, b.x) <= high_.x && std::max(a.y, b.y) >= low_.y &&
           std::min(a.y, b.y) <= high_.y;
  }
  LatticePoint low() const { return low_; }
  LatticePoint high() const { return high_; }

private:
  LatticePoint low_{INT32_MAX, INT32_MAX};
  LatticePoint high_{INT32_MIN, INT32_MIN};
};

}  // namespace

void EdgeIndex::Change::add(LatticePoint a, LatticePoint b, LatticePoint c)
{
  const std::int64_t area = cross(a, b, c);
  if (area > 0) triangles[triangle_count++] = {a, b, c};
  if (area < 0) triangles[triangle_count++] = {a, c, b};
}

void EdgeIndex::build(int cells_x, int cells_y, const Outlines& outlines)
{
  buckets_x_ = cells_x * kUnitsPerCell / kBucketSide + 1;
  buckets_y_ = cells_y * kUnitsPerCell / kBucketSide + 1;
  heads_.assign(static_cast<std::size_t>(buckets_x_) * static_cast<std::size_t>(buckets_y_), Outlines::kNone);
  entries_.clear();
  for (std::uint32_t from = 0; from < outlines.vertices.size(); ++from) {
    if (outlines.vertices[from].next != Outlines::kNone) add(from, outlines);
  }
}

void EdgeIndex::add(std::uint32_t from, const Outlines& outlines)
{
  const std::uint32_t to = outlines.vertices[from].next;
  const LatticePoint a = outlines.vertices[from].at;
  const LatticePoint b = outlines.vertices[to].at;
  const int last_x = std::max(a.x, b.x) / kBucketSide;
  const int last_y = std::max(a.y, b.y) / kBucketSide;
  for (int y = std::min(a.y, b.y) / kBucketSide; y <= last_y; ++y) {
    for (int x = std::min(a.x, b.x) / kBucketSide; x <= last_x; ++x) {
      std::uint32_t& head = heads_[bucket(x, y)];
      entries_.push_back({from, to, head});
      head = static_cast<std::uint32_t>(entries_.size() - 1);
    }
  }
}

bool EdgeIndex::keepsClearOf(const Entry& entry, const Change& change, const Outlines& outlines)
{
  for (std::uint32_t own = change.first; own != change.last; own = outlines.vertices[own].next) {
    if (entry.from == own) return true;
  }
  const LatticePoint from = outlines.vertices[entry.from].at;
  const LatticePoint to = outlines.vertices[entry.to].at;
  for (std::size_t n = 0; n < change.triangle_count; ++n) {
    const Triangle& triangle = change.triangles[n];
    if (entry.to == change.first) {
      if (!fansOut(triangle, to, from)) return false;
    } else if (entry.from == change.last) {
      if (!fansOut(triangle, from, to)) return false;
    } else if (!separatedByALine(triangle, from, to)) {
      return false;
    }
  }
  return true;
}

bool EdgeIndex::isClear(const Change& change, const Outlines& outlines)
{
  Box box;
  for (std::size_t n = 0; n < change.triangle_count; ++n) {
    for (const LatticePoint corner : change.triangles[n]) box.include(corner);
  }
  box.growBy(kClearance);
  const int last_x = std::min(buckets_x_ - 1, box.high().x / kBucketSide);
  const int last_y = std::min(buckets_y_ - 1, box.high().y / kBucketSide);
  for (int y = std::max(0, box.low().y) / kBucketSide; y <= last_y; ++y) {
    for (int x = std::max(0, box.low().x) / kBucketSide; x <= last_x; ++x) {
      std::uint32_t* link = &heads_[bucket(x, y)];
      while (*link != Outlines::kNone) {
        Entry& entry = entries_[*link];
        const Outlines::Vertex& from = outlines.vertices[entry.from];
        if (from.next != entry.to) {
          *link = entry.next;
          continue;
        }
        link = &entry.next;
        if (!box.overlapsBoxOf(from.at, outlines.vertices[entry.to].at)) continue;
        if (!keepsClearOf(entry, change, outlines)) return false;
      }
    }
  }
  return true;
}

}  // namespace polygonal_perception::occupancy

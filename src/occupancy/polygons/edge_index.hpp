#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "polygonal_perception/occupancy/polygons/lattice.hpp"
#include "polygonal_perception/occupancy/polygons/outlines.hpp"

namespace polygonal_perception::occupancy {

/// Finds the edges of outlines that are in the way of a change. Edges are kept in square buckets; one that
/// has left its ring since is forgotten when it is come across.
class EdgeIndex
{
public:
  /// What every vertex keeps from every edge that it is not an end of. It is far above the rounding of a
  /// float32 message, which thus cannot make two features touch.
  static constexpr std::int32_t kClearance = kUnitsPerCell / 16;

  using Triangle = std::array<LatticePoint, 3>;

  /// What replacing a chain of a ring's vertices adds to the ground that the ring encloses.
  struct Change
  {
    /// Takes in a triangle, unless it has no area.
    void add(LatticePoint a, LatticePoint b, LatticePoint c);

    std::uint32_t first = 0;  ///< the chain goes from here ...
    std::uint32_t last = 0;   ///< ... to here; both ends stay
    std::array<Triangle, 3> triangles;
    std::size_t triangle_count = 0;
  };

  /// Forgets everything and takes in all edges.
  void build(int cells_x, int cells_y, const Outlines& outlines);
  /// Takes in the edge that leaves a vertex.
  void add(std::uint32_t from, const Outlines& outlines);

  /// Does the change keep the clearance from all edges but the chain's own? The edges before and after the
  /// chain touch it in the chain's first and last vertex.
  bool isClear(const Change& change, const Outlines& outlines);

private:
  struct Entry
  {
    std::uint32_t from;
    std::uint32_t to;
    std::uint32_t next;  ///< entry of the bucket
  };

  std::size_t bucket(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(buckets_x_) + static_cast<std::size_t>(x);
  }
  static bool keepsClearOf(const Entry& entry, const Change& change, const Outlines& outlines);

  int buckets_x_ = 0;
  int buckets_y_ = 0;
  std::vector<std::uint32_t> heads_;
  std::vector<Entry> entries_;
};

}  // namespace polygonal_perception::occupancy

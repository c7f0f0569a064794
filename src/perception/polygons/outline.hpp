#pragma once

#include <cstdint>
#include <vector>

#include "perception/grid/bit_grid.hpp"
#include "perception/polygons/lattice.hpp"

namespace polygonal_perception::perception {

/// The outlines of a grid's cells along their borders: closed, simple rings with solid ground to the left of
/// every edge, thus counter-clockwise round a component of cells and clockwise round a hole in one.
///
/// Cells that meet in a corner only belong together (8-connected). There, where two stretches of outline
/// would touch, both give way by kCornerGap into the free cells, so that a narrow bridge joins the cells.
struct Outlines
{
  static constexpr std::int32_t kCornerGap = kUnitsPerCell / 8;
  static constexpr std::uint32_t kNone = UINT32_MAX;

  /// A vertex of a doubly linked ring.
  struct Vertex
  {
    LatticePoint at;
    std::uint32_t previous = kNone;
    std::uint32_t next = kNone;
  };

  struct Ring
  {
    std::uint32_t start = kNone;  ///< one of its vertices
    std::uint32_t size = 0;       ///< number of its vertices; 0 when the ring was given up
    /// What it lies in: of a hole the boundary, of a boundary the hole, if any.
    std::uint32_t parent = kNone;
    bool hole = false;
    bool has_nested_ring = false;  ///< a ring lies in it
  };

  /// Takes a vertex out of its ring; its `next` becomes kNone.
  void remove(std::uint32_t vertex, Ring& ring)
  {
    Vertex& removed = vertices[vertex];
    vertices[removed.previous].next = removed.next;
    vertices[removed.next].previous = removed.previous;
    if (ring.start == vertex) ring.start = removed.next;
    --ring.size;
    removed.next = kNone;
  }

  std::vector<Vertex> vertices;
  std::vector<Ring> rings;  ///< the parent stands before the child
};

/// Finds the outlines of a grid's cells.
class OutlineTracer
{
public:
  /// @param outlines  filled anew
  void trace(const BitGrid& cells, Outlines& outlines);

private:
  struct Line;

  void sweepLine(const Line& line, Outlines& outlines);
  void addCorner(const Line& line, int x, std::uint32_t surroundings, Outlines& outlines);
  void addCrossing(const Line& line, int x, std::uint32_t surroundings, Outlines& outlines);
  std::uint32_t addVertex(LatticePoint at, Outlines& outlines);
  void closeBelow(std::uint32_t vertex, int x, bool solid_before, Outlines& outlines);
  void closeBefore(std::uint32_t vertex, bool solid_above, Outlines& outlines) const;
  std::uint32_t outlineBefore(const Line& line, int x) const;
  void collectRings(Outlines& outlines);

  std::vector<std::uint64_t> outside_;     ///< a free row: what lies below the first row and above the last
  std::vector<std::uint32_t> open_below_;  ///< a column's vertex whose upper edge is being followed
  std::uint32_t open_before_ = 0;          ///< the line's vertex whose edge along x is being followed
  /// Of a vertex where a ring may start: a vertex of the outline next to it along -x.
  std::vector<std::uint32_t> before_;
  std::vector<std::uint32_t> ring_of_;  ///< the ring of a vertex
};

}  // namespace polygonal_perception::perception

#pragma once

#include <cstdint>
#include <vector>

#include "polygonal_perception/occupancy/polygons/lattice.hpp"

namespace polygonal_perception::occupancy {

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

}  // namespace polygonal_perception::occupancy

#pragma once

#include <cstdint>
#include <vector>

#include "bit_grid.hpp"

namespace polygonal_perception {

/// Coordinates of outlines are whole numbers of sixteenths of a cell, so that every test of one is exact.
constexpr std::int32_t kUnitsPerCell = 16;

/// The outlines of a grid's cells along their borders: closed, simple rings with solid ground to the left of
/// every edge, thus counter-clockwise round a component of cells and clockwise round a hole in one.
///
/// Cells that meet in a corner only belong together (8-connected). There, where two stretches of outline
/// would touch, both give way by kParting into the free cells, so that a narrow bridge joins the cells.
struct Outlines
{
  static constexpr std::int32_t kParting = kUnitsPerCell / 8;
  static constexpr std::uint32_t kNone = UINT32_MAX;

  /// A vertex of a doubly linked ring.
  struct Vertex
  {
    std::int32_t x = 0;
    std::int32_t y = 0;
    std::uint32_t previous = kNone;
    std::uint32_t next = kNone;
  };

  struct Ring
  {
    std::uint32_t start = kNone;   ///< one of its vertices
    std::uint32_t size = 0;        ///< number of its vertices
    std::uint32_t parent = kNone;  ///< the boundary whose hole this is; kNone for a boundary
  };

  std::vector<Vertex> vertices;
  std::vector<Ring> rings;  ///< a boundary stands before its holes
};

/// Finds the outlines of a grid's cells.
class OutlineTracer
{
public:
  /// @param outlines  filled anew
  void trace(const BitGrid& cells, Outlines& outlines);

private:
  void sweepRow(const BitGrid& cells, int y, Outlines& outlines);
  void collectRings(Outlines& outlines);

  std::vector<std::uint64_t> outside_;     ///< a free row: what lies below the first row and above the last
  std::vector<std::uint32_t> open_below_;  ///< a column's vertex whose upper edge is being followed
  std::vector<std::uint32_t>
      left_of_;  ///< a vertex of the outline to the left of a vertex at which a hole may start
  std::vector<std::uint32_t> ring_of_;  ///< the ring of a vertex
};

}  // namespace polygonal_perception

#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "polygonal_perception/occupancy/polygons/outline_tracer.hpp"
#include "polygonal_perception/occupancy/polygons/outlines.hpp"
#include "support/bits_from_text.hpp"

namespace polygonal_perception::perception {

/// How gtest prints it.
inline void PrintTo(occupancy::LatticePoint point, std::ostream* out)
{
  *out << '(' << point.x << ", " << point.y << ')';
}

}  // namespace polygonal_perception::perception

namespace polygonal_perception::test {

using Corners = std::vector<occupancy::LatticePoint>;

/// Corners that are given in whole cells.
inline Corners inCells(Corners corners)
{
  for (auto& corner : corners) {
    corner.x *= occupancy::kUnitsPerCell;
    corner.y *= occupancy::kUnitsPerCell;
  }
  return corners;
}

/// Adds a ring through corners of the lattice, its start first. It counts as a boundary of its own.
inline void addRing(const Corners& corners, occupancy::Outlines& outlines)
{
  const auto first = static_cast<std::uint32_t>(outlines.vertices.size());
  const auto size = static_cast<std::uint32_t>(corners.size());
  for (std::uint32_t n = 0; n < size; ++n)
    outlines.vertices.push_back({corners[n], first + (n + size - 1) % size, first + (n + 1) % size});
  occupancy::Outlines::Ring ring;
  ring.start = first;
  ring.size = size;
  outlines.rings.push_back(ring);
}

inline occupancy::Outlines outlinesThrough(const std::vector<Corners>& rings)
{
  occupancy::Outlines outlines;
  for (const Corners& corners : rings) addRing(corners, outlines);
  return outlines;
}

inline occupancy::Outlines traced(const occupancy::BitGrid& cells)
{
  occupancy::Outlines outlines;
  occupancy::OutlineTracer().trace(cells, outlines);
  return outlines;
}

/// The outlines of cells as they are drawn.
inline occupancy::Outlines traced(const std::vector<std::string>& lines)
{
  return traced(bitsFromText(lines));
}

/// The corners of a ring from its start.
inline Corners cornersOf(const occupancy::Outlines& outlines, std::size_t ring)
{
  Corners corners;
  std::uint32_t vertex = outlines.rings.at(ring).start;
  for (std::uint32_t n = 0; n < outlines.rings[ring].size; ++n) {
    corners.push_back(outlines.vertices.at(vertex).at);
    vertex = outlines.vertices[vertex].next;
  }
  return corners;
}

/// Of all rings that are left.
inline std::size_t verticesOf(const occupancy::Outlines& outlines)
{
  std::size_t count = 0;
  for (const auto& ring : outlines.rings) count += ring.size;
  return count;
}

/// Twice the area, positive when the corners run counter-clockwise.
inline std::int64_t twiceArea(const Corners& corners)
{
  std::int64_t area = 0;
  for (std::size_t n = 2; n < corners.size(); ++n)
    area += occupancy::cross(corners.front(), corners[n - 1], corners[n]);
  return area;
}

}  // namespace polygonal_perception::test

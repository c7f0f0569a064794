#pragma once

#include <cstdint>
#include <vector>

#include "edge_index.hpp"
#include "outline.hpp"
#include "proximity.hpp"

namespace polygonal_perception {

/// Saves vertices of outlines by adding ground to what they enclose, and never taking any away (a progressive
/// hull):
/// - an inward or straight vertex is cut off by the line between its neighbours;
/// - an edge between two outward vertices goes, its neighbours being extended until they meet;
/// - a hole that is small for the number of its vertices is given up.
/// What adds the least ground goes first. Nothing is done that would go beyond the limit or the grid's
/// rectangle, or come near to another edge.
class Simplification
{
public:
  /// @param cells_x,cells_y  size of the grid
  /// @param max_added_area   [cells] for each vertex saved
  /// @param proximity        the limit
  void simplify(int cells_x, int cells_y, double max_added_area, Proximity& proximity, Outlines& outlines);

private:
  void simplifyRing(Outlines::Ring& ring, std::int64_t max_cost);
  bool removeVertex(std::uint32_t vertex, Outlines::Ring& ring, std::uint32_t& resume);
  bool cutOff(std::uint32_t vertex, Outlines::Ring& ring);
  bool extendNeighbours(std::uint32_t vertex, Outlines::Ring& ring);
  void giveUpIfSmall(Outlines::Ring& hole, std::int64_t max_cost);

  bool isAllowed(const EdgeIndex::Change& change);
  bool meetOutside(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d,
                   LatticePoint& meeting) const;
  std::int64_t costOf(std::uint32_t vertex) const;
  void updateCosts(std::uint32_t first, std::uint32_t last);

  LatticePoint at(std::uint32_t vertex) const { return outlines_->vertices[vertex].at; }
  std::uint32_t next(std::uint32_t vertex) const { return outlines_->vertices[vertex].next; }
  std::uint32_t previous(std::uint32_t vertex) const { return outlines_->vertices[vertex].previous; }

  Outlines* outlines_ = nullptr;
  Proximity* proximity_ = nullptr;
  LatticePoint grid_corner_;
  EdgeIndex edges_;
  std::vector<std::int64_t> costs_;  ///< twice the area that saving a vertex adds
};

}  // namespace polygonal_perception

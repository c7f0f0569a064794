#pragma once

#include <cstdint>
#include <vector>

#include "occupancy/polygons/edge_index.hpp"
#include "occupancy/polygons/proximity.hpp"
#include "polygonal_perception/occupancy/polygons/outlines.hpp"

namespace polygonal_perception::occupancy {

/// The ways to save vertices of outlines. Each adds ground to what they enclose and takes none away (a
/// progressive hull), and none is gone that would lead beyond the limit or the grid's rectangle, or near to
/// another edge:
/// - an inward or straight vertex is cut off by the line between its neighbours;
/// - an edge between two outward vertices goes, its neighbours being extended until they meet;
/// - a hole is given up.
class OutlineReduction
{
public:
  /// The cost of what cannot be done.
  static constexpr std::int64_t kNever = INT64_MAX;

  /// Takes on outlines, which live as long as they are reduced.
  /// @param cells_x,cells_y  size of the grid
  /// @param proximity        the limit
  void start(int cells_x, int cells_y, Proximity& proximity, Outlines& outlines);

  std::uint32_t next(std::uint32_t vertex) const { return outlines_->vertices[vertex].next; }
  /// What saving the vertex adds: twice its area in lattice units.
  std::int64_t cost(std::uint32_t vertex) const { return costs_[vertex]; }

  /// Saves a vertex by one of the first two ways.
  /// @param resume  where to go on after success: costs have changed from there
  bool removeVertex(std::uint32_t vertex, Outlines::Ring& ring, std::uint32_t& resume);
  /// @param max_cost  for each of the hole's vertices
  bool fillHole(Outlines::Ring& hole, std::int64_t max_cost);

private:
  bool cutOff(std::uint32_t vertex, Outlines::Ring& ring);
  bool extendNeighbours(std::uint32_t vertex, Outlines::Ring& ring);

  bool isAllowed(const EdgeIndex::Change& change);
  bool isInGrid(LatticePoint point) const;
  bool meetOutside(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d,
                   LatticePoint& meeting) const;
  std::uint32_t insert(LatticePoint point, std::uint32_t previous, Outlines::Ring& ring);
  std::int64_t costOf(std::uint32_t vertex) const;
  void updateCosts(std::uint32_t first, std::uint32_t last);

  LatticePoint at(std::uint32_t vertex) const { return outlines_->vertices[vertex].at; }
  std::uint32_t previous(std::uint32_t vertex) const { return outlines_->vertices[vertex].previous; }

  Outlines* outlines_ = nullptr;
  Proximity* proximity_ = nullptr;
  LatticePoint grid_corner_;
  EdgeIndex edges_;
  std::vector<std::int64_t> costs_;
};

}  // namespace polygonal_perception::occupancy

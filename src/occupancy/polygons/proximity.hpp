#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "polygonal_perception/occupancy/grid/bit_grid.hpp"
#include "polygonal_perception/occupancy/polygons/lattice.hpp"

namespace polygonal_perception::occupancy {

/// Tells whether triangles lie within a limit of the occupied cells: the tightness of the polygon contract.
///
/// The points within the limit of one cell's square are a convex set, so that a triangle lies in it if its
/// corners do. A triangle that no single cell accounts for is halved a few times.
class Proximity
{
public:
  /// @param limit   [cells] from an occupied cell's square
  /// @param margin  [cells] by which the limit is known to lie beyond every covered cell; may be negative
  void setLimit(double limit, double margin);

  /// The cells that count from now on; they must outlive the questions.
  /// @param covered  the inflated cells, which are all within the limit
  void setCells(const BitGrid& occupied, const BitGrid& covered);

  /// True only if every point of the triangle is within the limit of an occupied cell, or if it has no area.
  bool covers(LatticePoint a, LatticePoint b, LatticePoint c);

private:
  struct Corner;
  using Triangle = std::array<Corner, 3>;

  bool covers(const Triangle& triangle, int halvings);
  bool coversHalves(const Triangle& triangle, int halvings);
  bool isInside(const Triangle& triangle) const;
  bool isNearWitness(const Triangle& triangle) const;
  bool findWitness(const Triangle& triangle);

  double limit_ = -1.0;
  double margin_ = 0.0;
  /// Of the limit's disc at a height above its centre; both in units of the lattice.
  std::vector<std::int32_t> half_widths_;
  /// [cells] Of the shape by which covered cells grow to inside_.
  std::vector<int> margin_half_widths_;
  const BitGrid* occupied_ = nullptr;
  BitGrid inside_;  ///< cells of which every point is within the limit; not all such
  /// The cell that accounted for the last triangle, often good for the next one; -1: none yet.
  int witness_i_ = -1;
  int witness_j_ = -1;
};

}  // namespace polygonal_perception::occupancy

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "polygonal_perception/geometry/polygon_set.hpp"
#include "polygonal_perception/occupancy/grid/binary_grid.hpp"

namespace polygonal_perception::reference {

/// A length in cells as a fraction, so that it can be compared without rounding.
struct CellLength
{
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;
};

/// The polygon contract, checked in whole numbers: polygons have their vertices on a lattice of 64ths of a
/// cell.
///
/// 1. rings are simple and have at least 3 vertices, boundaries counter-clockwise, holes clockwise and
///    inside;
/// 2. polygons do not overlap (rings do not even touch);
/// 3. every occupied cell's square, grown by the radius and clipped to the grid, lies inside them: no edge
///    comes nearer to an occupied square than the radius, but for edges along the grid's border, and all
///    occupied cells are inside;
/// 4. no point of an edge is farther from an occupied square than the limit, nor any point inside that is a
///    32nd of a cell or more away from an edge.
class PolygonChecker
{
public:
  /// @param radius  robot_radius
  /// @param limit   robot_radius + 1.5 cells + simplification_tolerance
  PolygonChecker(const occupancy::BinaryGrid& occupancy, const geometry::PolygonSet& polygons,
                 CellLength radius, CellLength limit);

  /// @return the first clause that is broken, and where; nothing when all hold
  std::optional<std::string> fault() const;

  // The same for some of the clauses.
  std::optional<std::string> notOnLattice() const;
  std::optional<std::string> notSimple() const;     ///< 1 and 2
  std::optional<std::string> wrongNesting() const;  ///< 1 and 2
  std::optional<std::string> unsafe() const;        ///< 3
  std::optional<std::string> loose() const;         ///< 4

private:
  struct Point
  {
    std::int64_t x, y;
  };
  using Ring = std::vector<Point>;
  struct Edge
  {
    Point a, b;
    std::size_t ring, index;
  };

  static std::int64_t cross(Point a, Point b, Point c);
  static bool touch(const Edge& e, const Edge& f);
  static bool inside(const Ring& ring, Point p);
  bool insidePolygons(Point p) const;
  bool onBorder(const Edge& edge) const;
  bool nearerThan(const Edge& edge, Point corner, CellLength length) const;
  bool within(Point p, Point corner, CellLength length) const;
  template <class Predicate>
  bool anyNear(Point p, Predicate&& holds) const;
  bool crossed(Point corner, std::int64_t side) const;
  bool reachable(Point a, Point b, int depth) const;
  bool reachable(Point corner, std::int64_t side) const;

  occupancy::BinaryGrid grid_;
  CellLength radius_, limit_;
  std::int64_t width_, height_;  // of the grid, in 64ths of a cell
  std::vector<Ring> rings_;
  std::vector<bool> is_hole_;
  std::vector<std::size_t> boundary_of_;  // the ring whose hole a ring is, or the ring itself
  std::vector<Edge> edges_;
  std::vector<Point> occupied_;  // lower corners of the occupied squares
  bool on_lattice_ = true;
};

}  // namespace polygonal_perception::reference

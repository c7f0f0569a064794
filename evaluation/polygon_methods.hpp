#pragma once

#include <memory>
#include <string>
#include <vector>

#include "polygonal_perception/geometry/polygon_set.hpp"
#include "polygonal_perception/occupancy/grid/binary_grid.hpp"

namespace polygonal_perception::evaluation {

/// A frame's cells, to be turned into polygons.
struct PolygonTask
{
  occupancy::BinaryGrid occupancy;
  occupancy::BinaryGrid inflated;
  geometry::PolygonSet
      outlines;         ///< of the inflated cells along their borders: what other methods start from
  double robot_radius;  ///< [m]
  double tolerance;     ///< [m]
  double added_share;   ///< of the outlines' area: what this package adds to it
};

/// @return the task of inflating and outlining a grid
PolygonTask makePolygonTask(const occupancy::BinaryGrid& occupancy, double robot_radius, double tolerance);

/// A way from inflated cells to polygons.
class PolygonMethod
{
public:
  virtual ~PolygonMethod() = default;
  virtual std::string name() const = 0;
  /// @param polygons  filled anew; those of other methods may break any clause of the contract
  virtual void polygonize(const PolygonTask& task, geometry::PolygonSet& polygons) = 0;
};

/// This package, then the others that there are libraries for.
std::vector<std::unique_ptr<PolygonMethod>> makePolygonMethods();

/// Built only where GEOS is found.
std::vector<std::unique_ptr<PolygonMethod>> makeGeosMethods();
/// Built only where CGAL is found.
std::unique_ptr<PolygonMethod> makeCgalMethod();

/// Adds a ring of points that have members x and y [m].
template <class Points>
void addRing(const Points& points, bool hole, geometry::PolygonSet& polygons)
{
  polygons.rings.push_back({static_cast<std::uint32_t>(polygons.vertices.size()),
                            static_cast<std::uint32_t>(points.size()), hole});
  for (const auto& point : points) polygons.vertices.emplace_back(point.x, point.y);
}

}  // namespace polygonal_perception::evaluation

#include "polygonal_perception/occupancy/polygons/polygonizer.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "occupancy/polygons/closing.hpp"
#include "occupancy/polygons/proximity.hpp"
#include "occupancy/polygons/simplification.hpp"
#include "occupancy/polygons/staircase_bridging.hpp"
#include "occupancy/polygons/vertex_estimate.hpp"
#include "polygonal_perception/occupancy/grid/bit_grid.hpp"
#include "polygonal_perception/occupancy/polygons/outline_tracer.hpp"
#include "polygonal_perception/occupancy/polygons/outlines.hpp"

namespace polygonal_perception::occupancy {

namespace {

/// [cells] How far beyond robot_radius and tolerance the contract lets a polygon reach: what whole cells and
/// the bridging of their slanted steps may take.
constexpr double kDiscretisation = 1.5;
/// [cells] From this tolerance on, gaps are closed: small obstacles stand close together for it.
constexpr double kLeastToClose = 2.0;
/// The area that a vertex is worth, in squares of the tolerance: less where the radius is many times the
/// tolerance, because outlines are long there and small additions along them sum up. doc/polygons.md has what
/// follows from it.
constexpr double kMostArea = 3.0;
constexpr double kLeastArea = 1.5;
constexpr double kLessPerRadius = 0.25;  // for each time that the radius is the tolerance
/// [cells] How far the steps of a slanted outline stray from a line. Contours through the centres of cells,
/// which the contract counts on, have no such steps.
constexpr double kSteps = 0.65;
/// Up to so many times the estimate there are few enough vertices: about as many as Douglas-Peucker leaves.
constexpr double kEnough = 1.35;

/// [cells] The area that may be added to save a vertex: that of a cell at least.
double areaPerVertex(double radius, double tolerance)
{
  const double squared = tolerance * tolerance;
  return std::max({1.0, kLeastArea * squared, kMostArea * squared - kLessPerRadius * radius * tolerance});
}

}  // namespace

struct Polygonizer::Workspace
{
  BitGrid occupied;
  BitGrid inflated;
  Closing closing;
  OutlineTracer tracer;
  Outlines outlines;
  Proximity proximity;
  StaircaseBridging bridging;
  Simplification simplification;
  std::vector<std::uint32_t> first_hole;  ///< of a ring
  std::vector<std::uint32_t> next_hole;   ///< of the same parent, after this ring

  void writePolygons(const GridGeometry& geometry, geometry::PolygonSet& polygons);
  void writeRing(const Outlines::Ring& ring, const GridGeometry& geometry,
                 geometry::PolygonSet& polygons) const;
};

void Polygonizer::Workspace::writeRing(const Outlines::Ring& ring, const GridGeometry& geometry,
                                       geometry::PolygonSet& polygons) const
{
  const double unit = geometry.resolution / kUnitsPerCell;
  polygons.rings.push_back({static_cast<std::uint32_t>(polygons.vertices.size()), ring.size, ring.hole});
  std::uint32_t vertex = ring.start;
  for (std::uint32_t n = 0; n < ring.size; ++n) {
    const LatticePoint at = outlines.vertices[vertex].at;
    polygons.vertices.emplace_back(geometry.origin_x + at.x * unit, geometry.origin_y + at.y * unit);
    vertex = outlines.vertices[vertex].next;
  }
}

void Polygonizer::Workspace::writePolygons(const GridGeometry& geometry, geometry::PolygonSet& polygons)
{
  polygons.clear();
  const std::vector<Outlines::Ring>& rings = outlines.rings;
  first_hole.assign(rings.size(), Outlines::kNone);
  next_hole.assign(rings.size(), Outlines::kNone);
  for (std::size_t r = rings.size(); r-- > 0;) {
    if (!rings[r].hole || rings[r].size == 0) continue;
    next_hole[r] = first_hole[rings[r].parent];
    first_hole[rings[r].parent] = static_cast<std::uint32_t>(r);
  }
  for (std::size_t r = 0; r < rings.size(); ++r) {
    if (rings[r].hole) continue;
    writeRing(rings[r], geometry, polygons);
    for (std::uint32_t hole = first_hole[r]; hole != Outlines::kNone; hole = next_hole[hole]) {
      writeRing(rings[hole], geometry, polygons);
    }
  }
}

Polygonizer::Polygonizer(const Parameters& parameters)
    : parameters_(parameters), workspace_(std::make_unique<Workspace>())
{
}
Polygonizer::Polygonizer(Polygonizer&&) noexcept = default;
Polygonizer& Polygonizer::operator=(Polygonizer&&) noexcept = default;
Polygonizer::~Polygonizer() = default;

void Polygonizer::polygonize(const BinaryGrid& occupancy, const BinaryGrid& inflated, double robot_radius,
                             geometry::PolygonSet& polygons)
{
  const GridGeometry& geometry = inflated.geometry();
  const double radius = robot_radius / geometry.resolution;
  const double tolerance = parameters_.simplification_tolerance / geometry.resolution;
  const int closed_gap = tolerance < kLeastToClose ? 0 : static_cast<int>(std::sqrt(2.0) * tolerance);
  // No point of an inflated cell, or of one in a closed gap, is farther from an occupied one than this.
  const double covered_reach = radius + std::sqrt(2.0) + closed_gap * std::sqrt(0.5);
  const double limit = radius + kDiscretisation + tolerance;

  Workspace& work = *workspace_;
  work.occupied.pack(occupancy);
  work.inflated.pack(inflated);
  work.closing.close(closed_gap, work.inflated);
  work.tracer.trace(work.inflated, work.outlines);
  work.proximity.setLimit(limit, limit - covered_reach);
  work.proximity.setCells(work.occupied, work.inflated);
  const std::size_t estimate = estimateVertices(work.outlines, tolerance + kSteps);
  work.bridging.bridge(work.inflated, work.proximity, work.outlines);
  work.simplification.simplify(geometry.cells_x, geometry.cells_y, areaPerVertex(radius, tolerance),
                               static_cast<std::size_t>(kEnough * static_cast<double>(estimate)),
                               work.proximity, work.outlines);
  work.writePolygons(geometry, polygons);
}

}  // namespace polygonal_perception::occupancy

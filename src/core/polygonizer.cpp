#include "polygonal_perception/polygonizer.hpp"

#include <vector>

#include "bit_grid.hpp"
#include "outline.hpp"

namespace polygonal_perception {

struct Polygonizer::Workspace
{
  BitGrid inflated;
  OutlineTracer tracer;
  Outlines outlines;
  std::vector<std::uint32_t> first_hole;  ///< of a ring
  std::vector<std::uint32_t> next_hole;   ///< of the same parent, after this ring

  void writePolygons(const GridGeometry& geometry, PolygonSet& polygons);
  void writeRing(const Outlines::Ring& ring, const GridGeometry& geometry, PolygonSet& polygons) const;
};

void Polygonizer::Workspace::writeRing(const Outlines::Ring& ring, const GridGeometry& geometry,
                                       PolygonSet& polygons) const
{
  const double unit = geometry.resolution / kUnitsPerCell;
  polygons.rings.push_back(
      {static_cast<std::uint32_t>(polygons.vertices.size()), ring.size, ring.parent != Outlines::kNone});
  std::uint32_t at = ring.start;
  for (std::uint32_t n = 0; n < ring.size; ++n) {
    const Outlines::Vertex& vertex = outlines.vertices[at];
    polygons.vertices.emplace_back(geometry.origin_x + vertex.x * unit, geometry.origin_y + vertex.y * unit);
    at = vertex.next;
  }
}

void Polygonizer::Workspace::writePolygons(const GridGeometry& geometry, PolygonSet& polygons)
{
  polygons.clear();
  const std::vector<Outlines::Ring>& rings = outlines.rings;
  first_hole.assign(rings.size(), Outlines::kNone);
  next_hole.assign(rings.size(), Outlines::kNone);
  for (std::size_t r = rings.size(); r-- > 0;) {
    if (rings[r].parent == Outlines::kNone || rings[r].size == 0) continue;
    next_hole[r] = first_hole[rings[r].parent];
    first_hole[rings[r].parent] = static_cast<std::uint32_t>(r);
  }
  for (std::size_t r = 0; r < rings.size(); ++r) {
    if (rings[r].parent != Outlines::kNone) continue;
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

void Polygonizer::polygonize(const BinaryGrid& /*occupancy*/, const BinaryGrid& inflated,
                             double /*robot_radius*/, PolygonSet& polygons)
{
  Workspace& work = *workspace_;
  work.inflated.pack(inflated);
  work.tracer.trace(work.inflated, work.outlines);
  work.writePolygons(inflated.geometry(), polygons);
}

}  // namespace polygonal_perception

#pragma once

#include <cstring>
#include <string>

#include "polygonal_perception/mapping/map_file.hpp"

namespace polygonal_perception::test {

inline bool sameBits(double a, double b)
{
  return std::memcmp(&a, &b, sizeof a) == 0;
}

/// @return the first thing in which two maps differ by a bit; empty where they are the same
inline std::string difference(const mapping::MapFile& a, const mapping::MapFile& b)
{
  if (a.frame_id != b.frame_id) return "frame_id";
  if (!sameBits(a.inflation_radius, b.inflation_radius)) return "inflation_radius";
  if (a.polygons.rings.size() != b.polygons.rings.size()) return "number of rings";
  for (std::size_t r = 0; r < a.polygons.rings.size(); ++r) {
    const geometry::PolygonSet::Ring& ring = a.polygons.rings[r];
    const geometry::PolygonSet::Ring& other = b.polygons.rings[r];
    if (ring.hole != other.hole || ring.size != other.size)
      return "kind or size of ring " + std::to_string(r);
    for (std::size_t k = 0; k < ring.size; ++k) {
      const Eigen::Vector2d& p = a.polygons.view(ring)[k];
      const Eigen::Vector2d& q = b.polygons.view(other)[k];
      if (!sameBits(p.x(), q.x()) || !sameBits(p.y(), q.y()))
        return "vertex " + std::to_string(k) + " of ring " + std::to_string(r);
    }
  }
  if (a.cells.has_value() != b.cells.has_value()) return "whether there are cells";
  if (!a.cells) return {};
  if (a.cells->cells_x != b.cells->cells_x || a.cells->cells_y != b.cells->cells_y) return "number of cells";
  if (!sameBits(a.cells->resolution, b.cells->resolution)) return "resolution";
  if (!sameBits(a.cells->origin_x, b.cells->origin_x) || !sameBits(a.cells->origin_y, b.cells->origin_y))
    return "origin";
  if (a.cells->layers.size() != b.cells->layers.size()) return "number of layers";
  for (std::size_t k = 0; k < a.cells->layers.size(); ++k) {
    if (a.cells->layers[k].name != b.cells->layers[k].name) return "name of layer " + std::to_string(k);
    if (a.cells->layers[k].values != b.cells->layers[k].values) return "values of layer " + std::to_string(k);
  }
  return {};
}

}  // namespace polygonal_perception::test

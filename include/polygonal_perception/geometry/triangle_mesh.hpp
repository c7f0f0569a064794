#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace polygonal_perception::geometry {

/// Triangles that cover a convex region, each with its neighbours.
///
/// An edge between two triangles is two half-edges, one of each: half-edge 3 t + i runs from corner i of triangle t to
/// its next corner, counter-clockwise, so that the triangle lies to its left.
struct TriangleMesh
{
  /// In the place of an index: there is none.
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

  struct HalfEdge
  {
    std::uint32_t origin = kNone;  ///< the vertex in which it begins
    std::uint32_t twin = kNone;    ///< the half-edge that runs against it; kNone at the region's border
    /// How often more the polygons contain the triangle to its left than the one to its right.
    std::int32_t step = 0;
    bool constrained = false;  ///< it is a piece of a polygon's edge
  };

  std::vector<Eigen::Vector2d> vertices;  ///< [m]
  std::vector<HalfEdge> half_edges;       ///< three a triangle
  std::vector<std::uint32_t> outgoing;    ///< for each vertex, a half-edge that begins in it

  std::size_t triangleCount() const { return half_edges.size() / 3; }

  static std::uint32_t triangleOf(std::uint32_t half_edge) { return half_edge / 3; }
  /// The edge after it, and the one before it, around their triangle.
  static std::uint32_t next(std::uint32_t half_edge)
  {
    return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1;
  }
  static std::uint32_t previous(std::uint32_t half_edge)
  {
    return half_edge % 3 == 0 ? half_edge + 2 : half_edge - 1;
  }

  std::uint32_t origin(std::uint32_t half_edge) const { return half_edges[half_edge].origin; }
  std::uint32_t target(std::uint32_t half_edge) const { return half_edges[next(half_edge)].origin; }
  /// The corner of its triangle that is not on it.
  std::uint32_t apex(std::uint32_t half_edge) const { return half_edges[previous(half_edge)].origin; }
  std::uint32_t twin(std::uint32_t half_edge) const { return half_edges[half_edge].twin; }

  /// The next half-edge with the same origin, counter-clockwise or clockwise; kNone beyond the region's border.
  std::uint32_t nextAround(std::uint32_t half_edge) const { return twin(previous(half_edge)); }
  std::uint32_t previousAround(std::uint32_t half_edge) const
  {
    const std::uint32_t against = twin(half_edge);
    return against == kNone ? kNone : next(against);
  }

  const Eigen::Vector2d& originPoint(std::uint32_t half_edge) const { return vertices[origin(half_edge)]; }
  const Eigen::Vector2d& targetPoint(std::uint32_t half_edge) const { return vertices[target(half_edge)]; }
  const Eigen::Vector2d& apexPoint(std::uint32_t half_edge) const { return vertices[apex(half_edge)]; }

  void clear()
  {
    vertices.clear();
    half_edges.clear();
    outgoing.clear();
  }
};

}  // namespace polygonal_perception::geometry

#pragma once

#include "polygonal_perception/geometry/triangle_mesh.hpp"

namespace polygonal_perception::geometry {

/// The three ways in which a triangulation changes. Each leaves a whole mesh if the triangles that it makes are
/// counter-clockwise, which is for the caller to see to.
class MeshEditor
{
public:
  explicit MeshEditor(TriangleMesh& mesh) : mesh_(mesh) {}

  /// Two triangles that fill a square, whose corners become the first four vertices.
  void beginWithSquare(const Eigen::Vector2d& low, const Eigen::Vector2d& high);

  /// Cuts a triangle into three that meet in `point`.
  /// @return the new vertex
  std::uint32_t splitTriangle(std::uint32_t triangle, const Eigen::Vector2d& point);

  /// Cuts an edge in `point`, and with it the triangles on both of its sides. The edge is not on the border.
  /// @return the new vertex
  std::uint32_t splitEdge(std::uint32_t half_edge, const Eigen::Vector2d& point);

  /// Replaces the edge between two triangles by the other diagonal of their quadrilateral. `half_edge` and its twin
  /// are then the halves of that diagonal.
  void flip(std::uint32_t half_edge);

private:
  using HalfEdge = TriangleMesh::HalfEdge;
  /// Puts what half-edge `from` was into the place `to`, and tells its twin.
  void put(std::uint32_t to, const HalfEdge& edge);
  std::uint32_t addVertex(const Eigen::Vector2d& point);
  std::uint32_t addTriangle();
  void join(std::uint32_t a, std::uint32_t b);

  TriangleMesh& mesh_;
};

}  // namespace polygonal_perception::geometry

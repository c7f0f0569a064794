#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "geometry/mesh_editor.hpp"

namespace polygonal_perception::geometry {

/// Makes segments between vertices edges of a triangulation (S. W. Sloan, A fast algorithm for generating constrained
/// Delaunay triangulations, 1993).
class SegmentInsertion
{
public:
  /// Memory, to be used again.
  struct Scratch
  {
    std::vector<std::pair<std::uint32_t, std::uint32_t>>& edges;
    std::vector<std::uint32_t>& vertices;
  };

  /// @param crossings  how often segments may cross each other
  SegmentInsertion(TriangleMesh& mesh, std::size_t crossings, const Scratch& scratch)
      : mesh_(mesh),
        editor_(mesh),
        crossings_left_(crossings),
        crossing_(scratch.edges),
        goals_(scratch.vertices)
  {
  }

  /// Makes the segment from one vertex to another an edge, or a chain of edges: where it runs through a vertex, and where it
  /// crosses a constrained edge, which gets a vertex there, within rounding.
  ///
  /// @param step  how often more the polygons contain what lies to its left than what lies to its right
  /// @return nothing; or where it crosses a constrained edge too near to another vertex to be told apart from it
  std::optional<Eigen::Vector2d> insert(std::uint32_t from, std::uint32_t to, std::int32_t step);

private:
  /// How far an edge could be made.
  struct Reach
  {
    std::uint32_t vertex = TriangleMesh::kNone;   ///< up to there
    std::uint32_t crossed = TriangleMesh::kNone;  ///< or: a constrained edge is in the way
  };
  Reach reach(std::uint32_t from, std::uint32_t to);
  /// @return the new vertex; kNone where there would be triangles that are turned over
  std::uint32_t cross(std::uint32_t half_edge, const Eigen::Vector2d& from, const Eigen::Vector2d& to);
  void clearWay(std::uint32_t from, std::uint32_t to);
  void constrain(std::uint32_t from, std::uint32_t to, std::int32_t step);
  std::uint32_t find(std::uint32_t from, std::uint32_t to) const;

  TriangleMesh& mesh_;
  MeshEditor editor_;
  std::size_t crossings_left_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>>& crossing_;  // edges, by their ends
  std::vector<std::uint32_t>& goals_;
};

}  // namespace polygonal_perception::geometry

#pragma once

#include <Eigen/Core>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/predicates.hpp"
#include "polygonal_perception/geometry/triangle_mesh.hpp"
#include "polygonal_perception/planning/sleeve.hpp"

namespace polygonal_perception::planning {

/// The shortest path through a sleeve, by a funnel (D. T. Lee and F. P. Preparata, Euclidean shortest paths in the presence
/// of rectilinear barriers, 1984). Its turns are decided exactly, so that it never leaves the sleeve. Memory is used again.
class POLYGONAL_PERCEPTION_EXPORT TautPath
{
public:
  /// @param start  [m] in the sleeve's first triangle
  /// @param goal   [m] in its last one
  /// @param path   replaced by start, corners and goal
  /// @return its length [m]
  double pull(const geometry::TriangleMesh& mesh, const Sleeve& sleeve, const Eigen::Vector2d& start,
              const Eigen::Vector2d& goal, std::vector<Eigen::Vector2d>& path);

private:
  /// One side of the funnel: from the apex, which both share, to an end of the edge that was crossed last.
  struct Chain
  {
    std::vector<Eigen::Vector2d> points;
    std::size_t apex = 0;  // index of it

    void beginAt(const Eigen::Vector2d& point)
    {
      points.assign(1, point);
      apex = 0;
    }
    bool isApexAlone() const { return apex + 1 == points.size(); }
  };
  /// The edge crossed next has that end. Corners that the path has to go round by then are added to it.
  static void extend(Chain& side, Chain& other, const Eigen::Vector2d& end, geometry::Orientation way,
                     std::vector<Eigen::Vector2d>& path);

  Chain left_;
  Chain right_;
};

}  // namespace polygonal_perception::planning

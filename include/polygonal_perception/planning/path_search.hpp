#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/predicates.hpp"
#include "polygonal_perception/planning/free_space.hpp"
#include "polygonal_perception/planning/sleeve.hpp"

namespace polygonal_perception::planning {

/// The shortest path between two free places, by Minimal Construct (M. Missura, D. D. Lee and M. Bennewitz, IROS 2018): A*
/// over the visibility graph, of which only what the search touches is ever made, with convex corners and tangential edges
/// alone (section III). The paper guesses an edge and tests it when it is popped, which in an office is wrong 97 times of
/// 100; here the corners that a corner sees are found by triangular expansion (S. Bungiu et al., Efficient computation of
/// visibility polygons, 2014): a cone of rays goes from triangle to triangle through their open edges. A cone waits in the
/// same queue as the corners, with the least length of a path through it (M. Cui, D. Harabor and A. Grastien,
/// Compromise-free pathfinding on a navigation mesh, IJCAI 2017), so that it goes no farther than the search needs.
///
/// A cone's sides are lines through vertices, and whether a vertex lies in it is decided exactly. A path may touch
/// obstacles and run along them; it never leads through a point in which two of them touch.
class POLYGONAL_PERCEPTION_EXPORT PathSearch
{
public:
  /// A piece of the visibility graph.
  struct SeenEdge
  {
    Eigen::Vector2d from;
    Eigen::Vector2d to;
  };

  /// @param space  must outlive the search, or be set anew
  void setSpace(const FreeSpace& space);

  /// @param path  replaced by the start, the corners and the goal [m]; empty where there is no way
  /// @return its length [m]; nothing where there is no way
  std::optional<double> plan(const FreePlace& start, const FreePlace& goal,
                             std::vector<Eigen::Vector2d>& path);

  /// Of the last plan that found a path: the triangles through which it goes.
  void sleeve(Sleeve& sleeve) const;
  /// Of the last plan: the edges that were made, in the order in which they were.
  void seenEdges(std::vector<SeenEdge>& edges) const;
  /// Of the last plan: how many corners were expanded, and how many triangles cones went through.
  std::size_t expandedCorners() const { return expanded_corners_; }
  std::size_t crossedTriangles() const { return crossed_triangles_; }

private:
  static constexpr std::uint32_t kNone = geometry::TriangleMesh::kNone;

  /// A corner as an end of a path.
  struct Visit
  {
    std::uint32_t point = kNone;
    std::uint32_t parent = kNone;     // the visit that sees it
    std::uint32_t half_edge = kNone;  // begins in the corner, in the triangle through which it was seen
    std::uint32_t crossing = kNone;   // by which that triangle was entered
    double length = 0.0;              // [m] from the start
  };
  /// The line from one point to another, on which a cone's root lies, too.
  struct Side
  {
    std::uint32_t from = kNone;
    std::uint32_t to = kNone;
  };
  /// Rays from a visit's corner, through an edge.
  struct Cone
  {
    std::uint32_t root = kNone;       // a visit
    std::uint32_t half_edge = kNone;  // on this side of the edge
    std::uint32_t crossing = kNone;   // by which this side was entered
    Side right;
    Side left;
    bool has_right_end = true;  // the rays reach the edge's right end, its origin
    bool has_left_end = true;
  };
  /// A step from a triangle to the next one. The first of a chain has nothing before it, and begins in its triangle.
  struct Crossing
  {
    std::uint32_t half_edge = kNone;
    std::uint32_t before = kNone;
  };
  struct Queued
  {
    double estimate = 0.0;        // [m] no path through it is shorter
    std::uint32_t index = kNone;  // of a visit, or of a cone where is_cone
    bool is_cone = false;
    bool operator<(const Queued& other) const { return estimate > other.estimate; }
  };

  const Eigen::Vector2d& point(std::uint32_t index) const { return points_[index]; }
  geometry::Orientation sideOf(const Side& side, std::uint32_t point) const;
  void markGoal(const FreePlace& goal);
  void expandStart(const FreePlace& start);
  void expandCorner(std::uint32_t visit);
  /// What is seen from a corner by who bends there to the right (clockwise) or to the left.
  void turn(std::uint32_t visit, geometry::Orientation way);
  /// Whether a neighbour of a corner lies straight ahead of who comes to it, or to the side of that turn.
  bool isReached(const Side& ahead, std::uint32_t point, geometry::Orientation way) const;
  /// Follows a cone beyond its edge, as long as it stays one.
  void follow(Cone cone);
  /// A visit sees a point of the triangle that was entered by that crossing: where `half_edge` begins.
  void see(std::uint32_t root, std::uint32_t half_edge, std::uint32_t crossing);
  void seeGoal(const Cone& cone);
  void reach(std::uint32_t root, std::uint32_t point, std::uint32_t half_edge, std::uint32_t crossing);
  std::uint32_t cross(std::uint32_t half_edge, std::uint32_t before);
  bool isTangential(std::uint32_t from, std::uint32_t half_edge) const;
  void push(const Cone& cone);
  double estimate(const Cone& cone) const;
  Eigen::Vector2d crossing(const Side& side, std::uint32_t half_edge) const;
  double read(std::uint32_t visit, std::vector<Eigen::Vector2d>& path) const;

  const FreeSpace* space_ = nullptr;
  std::vector<Eigen::Vector2d> points_;  // the mesh's vertices, the start and the goal
  std::uint32_t start_ = kNone;
  std::uint32_t goal_ = kNone;
  std::vector<double> best_;                   // [m] the shortest way known to each point
  std::vector<std::uint32_t> touched_;         // those that have one
  std::vector<std::uint32_t> goal_triangles_;  // that contain the goal
  std::vector<std::uint8_t> has_goal_;         // of each triangle
  std::vector<Visit> visits_;
  std::vector<Cone> cones_;
  std::vector<Crossing> crossings_;
  std::vector<Queued> queue_;      // a heap
  std::uint32_t reached_ = kNone;  // the visit of the goal
  std::size_t expanded_corners_ = 0;
  std::size_t crossed_triangles_ = 0;
};

}  // namespace polygonal_perception::planning

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/polygon_set.hpp"
#include "polygonal_perception/planning/free_space.hpp"
#include "polygonal_perception/planning/path_search.hpp"
#include "polygonal_perception/planning/side_keeper.hpp"

namespace polygonal_perception::planning {

/// Why a plan is as it is.
enum class PlanOutcome : std::uint8_t
{
  kOk,
  kNoPolygons,    ///< no obstacles have been set, or they were refused
  kStartBlocked,  ///< the start is inside an obstacle that has no free border
  kGoalBlocked,   ///< the goal is inside an obstacle, and no free point is within the tolerance
  kUnreachable,   ///< both are free, and there is no way
  kOutside  ///< one of them lies beyond what was looked at, and that is blocked; or farther than any map
};

/// The way from a start to a goal, whatever they are.
struct Plan
{
  PlanOutcome outcome = PlanOutcome::kNoPolygons;
  /// [m] The start, where it leaves an obstacle, corners, and the goal or the free point that stands for it. Empty where
  /// there is no way.
  std::vector<Eigen::Vector2d> path;
  double length = 0.0;       ///< [m] of it
  double start_shift = 0.0;  ///< [m] from the start to where it leaves the obstacle that contains it
  double goal_shift = 0.0;   ///< [m] from the goal to the point that is reached
  double detour = 0.0;  ///< [m] by which it is longer than the shortest, to keep to its side of obstacles
};

/// Shortest paths among obstacles for everything that a robot meets: ends in obstacles, beyond the map, without a way.
class POLYGONAL_PERCEPTION_EXPORT PathPlanner
{
public:
  /// Replaces the obstacles. Memory is used again.
  ///
  /// @param obstacles  their borders are free
  /// @param extent     what was looked at, counter-clockwise, or fewer than 3 vertices: nothing was
  /// @param outside_is_free  whether paths may leave the extent
  /// @return nothing; or why the obstacles are refused: there are none until others come, and no plans
  std::optional<geometry::TriangulationFault> setObstacles(const geometry::PolygonSet& obstacles,
                                                           const std::vector<Eigen::Vector2d>& extent,
                                                           bool outside_is_free);

  /// @param goal_tolerance  [m] how far from a goal in an obstacle the path may end
  /// @param plan            replaced
  void makePlan(const Eigen::Vector2d& start, const Eigen::Vector2d& goal, double goal_tolerance, Plan& plan);

  /// Makes the last plan one that passes each obstacle on the side on which an earlier one did, unless the way there is
  /// blocked or a plan of another kind is shorter by more than a share: a robot that plans anew in each frame would go to and
  /// fro before two ways of the same length.
  ///
  /// @param share  0: the plan stays the shortest
  /// @param guide  [m] of the earlier plan, or empty; replaced by that of this one, for the next
  /// @param plan   as makePlan has left it
  void keepSide(double share, std::vector<Eigen::Vector2d>& guide, Plan& plan);

  /// Of the last plan, for pictures.
  const PathSearch& search() const { return search_; }

private:
  bool isOutside(const Eigen::Vector2d& point) const;
  /// The free place that stands for a goal in an obstacle: the nearest one that can be reached, if any is near enough, else
  /// the nearest one.
  std::optional<FreePlace> besideGoal(const Eigen::Vector2d& goal, double tolerance,
                                      const FreePlace& start) const;
  bool isConnected(const FreePlace& a, const FreePlace& b) const;

  bool has_obstacles_ = false;
  bool outside_is_free_ = true;
  std::vector<Eigen::Vector2d> extent_;
  std::vector<Eigen::Vector2d> around_;  // the extent, clockwise
  geometry::PolygonSet bounded_;         // the obstacles, and the extent as a hole in what else is blocked
  FreeSpace space_;
  PathSearch search_;
  FreePlace start_;  // of the last plan, both free
  FreePlace goal_;
  SideKeeper side_keeper_;
  std::vector<Eigen::Vector2d> free_path_;  // from start_ to goal_
  std::vector<Eigen::Vector2d> kept_path_;
  Sleeve sleeve_;
  Sleeve kept_sleeve_;
};

}  // namespace polygonal_perception::planning

#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Path.h>
#include <polygonal_perception/PolygonArray.h>

#include <chrono>
#include <optional>
#include <string>

#include "polygonal_perception/ros/common/frame_statistics.hpp"
#include "polygonal_perception/ros/common/stamp_order.hpp"
#include "polygonal_perception/ros/common/throttled_log.hpp"
#include "polygonal_perception/ros/planning/plan_outputs.hpp"
#include "polygonal_perception/ros/planning/polygon_planner.hpp"
#include "ros/planning/shortest_path_parameters.hpp"

namespace polygonal_perception::ros_planning {

/// How long each stage of a plan took.
struct PlanTimes
{
  using Duration = std::chrono::nanoseconds;

  Duration obstacles{0};  ///< taking in polygons
  Duration search{0};

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor&& visit)
  {
    visit("obstacles", self.obstacles);
    visit("search", self.search);
  }
};

/// Keeps the goal and the newest polygons, and plans on them in their frame.
class PlanMaker
{
public:
  PlanMaker(const ShortestPathParameters& parameters, const PlanOutputs& outputs,
            ros_common::FrameStatistics& statistics, ros_common::ThrottledLog& log);

  /// Answers polygons: a plan to the goal, or why there is none.
  /// @param may_wait  whether they may come again when the robot's transform is not there yet
  /// @return false: they are to come again
  bool process(const PolygonArrayConstPtr& polygons, bool may_wait);

  /// A goal stays until another one comes. Of one without an orientation (all of its quaternion 0) any yaw will do.
  void setGoal(const geometry_msgs::PoseStamped& goal);

  /// A plan on the newest polygons, for whoever asks.
  /// @param tolerance  [m] 0 or less: the parameter's
  /// @return without poses where there is none
  nav_msgs::Path makePlan(const geometry_msgs::PoseStamped& start, const geometry_msgs::PoseStamped& goal,
                          double tolerance);

  void configure(const ShortestPathParameters& parameters);
  /// Time has jumped back: forgets the transforms, the goal and the polygons.
  void resetTime(const std::string& reason);
  const ros::Time& newestStamp() const { return stamps_.newest(); }

private:
  /// Moves the goal into the fixed frame as soon as tf can.
  void fixGoal();
  ros_common::Expected<PolygonPlanner::Place> robotPlace() const;
  void publish(std::uint8_t status, const std::string& message);
  void refuse(std::uint8_t status, const char* kind, const std::string& reason);

  ShortestPathParameters parameters_;
  const PlanOutputs& outputs_;
  ros_common::FrameStatistics& statistics_;
  ros_common::ThrottledLog& log_;
  PolygonPlanner planner_;
  std::optional<geometry_msgs::PoseStamped> goal_;
  bool is_goal_fixed_ = false;
  planning::Plan plan_;
  std::optional<double> goal_yaw_;
  PlanTimes times_;
  ros_common::StampOrder stamps_;
};

}  // namespace polygonal_perception::ros_planning

#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Path.h>
#include <polygonal_perception/PolygonArray.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "polygonal_perception/planning/path_planner.hpp"
#include "polygonal_perception/ros/common/expected.hpp"
#include "polygonal_perception/ros/common/frame_statistics.hpp"
#include "polygonal_perception/ros/common/stamp_order.hpp"
#include "polygonal_perception/ros/common/tf_bridge.hpp"
#include "polygonal_perception/ros/common/throttled_log.hpp"
#include "ros/planning/plan_outputs.hpp"
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
  /// Where something is in the polygons' frame.
  struct Place
  {
    Eigen::Vector2d point;
    std::optional<double> yaw;  // nothing: any
  };
  ros_common::Expected<Place> placeOf(const geometry_msgs::PoseStamped& pose) const;
  /// Moves the goal into the fixed frame as soon as tf can.
  void fixGoal();
  ros_common::Expected<Place> robotPlace() const;
  /// What is wrong with the polygons; empty where they can be planned on. Takes them in, if that has not been done.
  std::string takeIn();
  /// Has the plan pass obstacles on the side on which the last one to that goal did.
  void keepSide(const Eigen::Vector2d& goal);
  void publish(std::uint8_t status, const std::string& message);
  void refuse(std::uint8_t status, const char* kind, const std::string& reason);

  ShortestPathParameters parameters_;
  const PlanOutputs& outputs_;
  ros_common::FrameStatistics& statistics_;
  ros_common::ThrottledLog& log_;
  ros_common::TfBridge tf_;
  planning::PathPlanner planner_;
  PolygonArrayConstPtr polygons_;  // the newest; null before the first
  bool are_taken_in_ = false;
  std::string fault_;  // of the polygons, once they are taken in
  std::optional<geometry_msgs::PoseStamped> goal_;
  bool is_goal_fixed_ = false;
  planning::Plan plan_;
  std::vector<Eigen::Vector2d> guide_;  // of the last plan, in the fixed frame
  std::optional<double> goal_yaw_;
  PlanTimes times_;
  ros_common::StampOrder stamps_;
};

}  // namespace polygonal_perception::ros_planning

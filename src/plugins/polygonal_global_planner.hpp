#pragma once

#include <costmap_2d/costmap_2d_ros.h>
#include <nav_core/base_global_planner.h>
#include <ros/publisher.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "plugins/global_planner_parameters.hpp"
#include "polygonal_perception/ros/common/callback_gate.hpp"
#include "polygonal_perception/ros/common/input_topics.hpp"
#include "polygonal_perception/ros/common/parameter_holder.hpp"
#include "polygonal_perception/ros/common/stamp_order.hpp"
#include "polygonal_perception/ros/common/throttled_log.hpp"
#include "polygonal_perception/ros/planning/plan_outputs.hpp"
#include "polygonal_perception/ros/planning/polygon_planner.hpp"

namespace polygonal_perception::plugins {

/// The shortest path over polygons for move_base: it plans on the newest PolygonArray of the topic `polygons`, and looks at
/// the costmap for nothing but its frame and its resolution.
class PolygonalGlobalPlanner : public nav_core::BaseGlobalPlanner
{
public:
  PolygonalGlobalPlanner() = default;
  ~PolygonalGlobalPlanner() override;
  PolygonalGlobalPlanner(const PolygonalGlobalPlanner&) = delete;
  PolygonalGlobalPlanner& operator=(const PolygonalGlobalPlanner&) = delete;

  /// Called once, by move_base. Parameters and outputs are in ~name.
  void initialize(std::string name, costmap_2d::Costmap2DROS* costmap_ros) override;

  /// @param plan  from start to goal in the costmap's frame, a pose each of its cells: local planners look for the pose
  ///              nearest to the robot
  /// @return false where there is none; the log and ~status say why
  bool makePlan(const geometry_msgs::PoseStamped& start, const geometry_msgs::PoseStamped& goal,
                std::vector<geometry_msgs::PoseStamped>& plan) override
  {
    double cost = 0.0;
    return makePlan(start, goal, plan, cost);
  }
  /// @param cost  [m] its length
  bool makePlan(const geometry_msgs::PoseStamped& start, const geometry_msgs::PoseStamped& goal,
                std::vector<geometry_msgs::PoseStamped>& plan, double& cost) override;

private:
  /// What initialize() makes.
  struct Members
  {
    Members(const ros::NodeHandle& private_handle, const costmap_2d::Costmap2DROS* costmap);

    std::shared_ptr<ros_common::CallbackGate> gate = std::make_shared<ros_common::CallbackGate>();
    std::string global_frame;
    double spacing;  // [m] between poses
    ros_common::ParameterHolder<GlobalPlannerParameters> parameters;
    ros_common::ThrottledLog log;
    ros_planning::PlanOutputs outputs;
    ros::Publisher dense_plan;
    ros_planning::PolygonPlanner planner;
    ros_common::StampOrder stamps;
    ros_common::InputTopics inputs;
    planning::Plan plan;
    std::optional<double> goal_yaw;
  };

  /// @return why there is no plan; empty where there is
  std::string findPlan(const geometry_msgs::PoseStamped& start, const geometry_msgs::PoseStamped& goal,
                       std::uint8_t& status);

  std::unique_ptr<Members> members_;
};

}  // namespace polygonal_perception::plugins

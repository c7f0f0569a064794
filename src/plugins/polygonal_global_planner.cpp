#include "plugins/polygonal_global_planner.hpp"

#include <nav_msgs/Path.h>
#include <polygonal_perception/PlanStatus.h>
#include <ros/this_node.h>

#include <cmath>
#include <pluginlib/class_list_macros.hpp>

#include "plugins/dense_plan.hpp"
#include "polygonal_perception/parameters/parameter_check.hpp"

namespace polygonal_perception::plugins {

PolygonalGlobalPlanner::Members::Members(const ros::NodeHandle& private_handle,
                                         const costmap_2d::Costmap2DROS* costmap)
    : global_frame(costmap->getGlobalFrameID()),
      spacing(costmap->getCostmap()->getResolution()),
      parameters(private_handle),
      log(private_handle.getNamespace()),
      outputs(private_handle, [] {}),
      // Beside move_base: a remapping of `polygons` in its launch file is enough.
      inputs(ros::NodeHandle(), ros::this_node::getName(), gate)
{
  ros_planning::addOutputs(outputs);
  ros::NodeHandle handle(private_handle);
  dense_plan = handle.advertise<nav_msgs::Path>("plan", 1);
}

PolygonalGlobalPlanner::~PolygonalGlobalPlanner()
{
  if (!members_) return;
  members_->gate->close();
  members_->parameters.shutdown();
}

void PolygonalGlobalPlanner::initialize(std::string name, costmap_2d::Costmap2DROS* costmap_ros)
{
  if (members_) {
    ROS_WARN_STREAM(name << ": is initialised already");
    return;
  }
  if (costmap_ros == nullptr) {
    ROS_ERROR_STREAM(name << ": there is no costmap, which has the frame of plans");
    return;
  }
  auto members = std::make_unique<Members>(ros::NodeHandle("~/" + name), costmap_ros);
  Members& m = *members;
  ros_common::InputTopics::Unsubscribed unsubscribed;  // ends outside of the gate
  const auto inside = m.gate->enter();
  m.parameters.serve(m.gate, [&m](const GlobalPlannerParameters& parameters) {
    m.planner.setOutsideIsFree(parameters.path.outsideIsFree());
  });
  m.planner.setOutsideIsFree(m.parameters->path.outsideIsFree());
  m.inputs.add<PolygonArray>("polygons", [&m](const PolygonArrayConstPtr& polygons) {
    const ros::Time& stamp = polygons->header.stamp;
    if (m.stamps.jumpsBack(stamp)) {
      m.log.warn("time", "the polygons' stamps have jumped back");
      m.planner.forget();
      m.stamps.reset();
    }
    m.stamps.take(stamp);
    m.planner.setPolygons(polygons);
  });
  unsubscribed = m.inputs.setSubscribed(true);
  if (!m.inputs.error().empty()) m.log.error("subscription", "cannot subscribe to " + m.inputs.error());
  members_ = std::move(members);
}

bool PolygonalGlobalPlanner::makePlan(const geometry_msgs::PoseStamped& start,
                                      const geometry_msgs::PoseStamped& goal,
                                      std::vector<geometry_msgs::PoseStamped>& plan, double& cost)
{
  plan.clear();
  cost = 0.0;
  if (!members_) {
    ROS_ERROR("PolygonalGlobalPlanner: makePlan before initialize");
    return false;
  }
  Members& m = *members_;
  const auto inside = m.gate->enter();
  if (!inside.owns_lock()) return false;
  m.plan = planning::Plan();
  std::uint8_t status = PlanStatus::NO_POLYGONS;
  std::string message = findPlan(start, goal, status);
  ros_common::Expected<Eigen::Isometry3d> to_global = Eigen::Isometry3d(Eigen::Isometry3d::Identity());
  if (message.empty()) {
    to_global = m.planner.transform(m.global_frame, m.planner.polygons()->header.frame_id);
    if (!to_global) message = to_global.error();
  }
  const bool is_found = message.empty();
  if (is_found) {
    message = ros_planning::textOf(m.plan);
    std_msgs::Header header;
    header.frame_id = m.global_frame;
    header.stamp = ros::Time::now();
    plan = densePlan(m.plan.path, *to_global, m.spacing, m.goal_yaw, header);
    cost = m.plan.length;
  } else {
    m.plan.path.clear();
    m.log.warn("plan", "no plan: " + message);
  }
  std_msgs::Header header;
  if (m.planner.polygons()) header = m.planner.polygons()->header;
  m.outputs.publish({header, status, message, m.plan, m.goal_yaw, m.planner.search()});
  nav_msgs::Path dense;
  dense.header.frame_id = m.global_frame;
  dense.header.stamp = ros::Time::now();
  dense.poses = plan;
  m.dense_plan.publish(dense);
  return is_found;
}

std::string PolygonalGlobalPlanner::findPlan(const geometry_msgs::PoseStamped& start,
                                             const geometry_msgs::PoseStamped& goal, std::uint8_t& status)
{
  Members& m = *members_;
  const GlobalPlannerParameters& parameters = *m.parameters;
  status = PlanStatus::NO_POLYGONS;
  if (!m.planner.polygons()) return "no polygons have come on " + m.inputs.topic();
  const double age = ros::Time::now().toSec() - m.planner.polygons()->header.stamp.toSec();
  // Those of a clock that is ahead would stay new for as long.
  if (std::abs(age) > parameters.timeout)
    return "the newest polygons are " + parameters::numberText(std::abs(age)) +
           (age > 0.0 ? " s old" : " s ahead of the clock") + ", accepted are " +
           parameters::numberText(parameters.timeout) + " s";
  if (const std::string error = m.planner.takeIn(); !error.empty()) return error;
  const auto from = m.planner.locate(start);
  status = PlanStatus::START_BLOCKED;
  if (!from) return from.error();
  const auto to = m.planner.locate(goal);
  status = PlanStatus::NO_GOAL;
  if (!to) return to.error();
  m.goal_yaw = to->yaw;
  m.planner.makePlan(*from, *to, parameters.path.goal_tolerance, m.plan);
  m.planner.keepSide(m.global_frame, parameters.path, *to, m.plan);
  status = ros_planning::statusOf(m.plan.outcome);
  return m.plan.outcome == planning::PlanOutcome::kOk ? std::string() : ros_planning::textOf(m.plan);
}

}  // namespace polygonal_perception::plugins

PLUGINLIB_EXPORT_CLASS(polygonal_perception::plugins::PolygonalGlobalPlanner, nav_core::BaseGlobalPlanner)

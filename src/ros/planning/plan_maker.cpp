#include "ros/planning/plan_maker.hpp"

#include <polygonal_perception/PlanStatus.h>

#include <cmath>

#include "polygonal_perception/ros/common/text_rules.hpp"

namespace polygonal_perception::ros_planning {

namespace {

using Clock = ros_common::FrameStatistics::Clock;

}  // namespace

PlanMaker::PlanMaker(const ShortestPathParameters& parameters, const PlanOutputs& outputs,
                     ros_common::FrameStatistics& statistics, ros_common::ThrottledLog& log)
    : parameters_(parameters), outputs_(outputs), statistics_(statistics), log_(log)
{
  configure(parameters);
}

bool PlanMaker::process(const PolygonArrayConstPtr& polygons, bool may_wait)
{
  const ros::Time& stamp = polygons->header.stamp;
  const std::string frame_error = ros_common::frameIdError(polygons->header.frame_id);
  if (frame_error.empty() && stamps_.jumpsBack(stamp)) resetTime("stamps of the polygons");
  planner_.setPolygons(polygons);
  plan_ = planning::Plan();
  if (!frame_error.empty()) {
    refuse(PlanStatus::NO_POLYGONS, "frame", frame_error);
    return true;
  }
  if (!outputs_.hasReaders()) {
    stamps_.take(stamp);
    statistics_.answered(times_, Clock::duration::zero());
    return true;
  }
  if (!goal_) {
    stamps_.take(stamp);
    publish(PlanStatus::NO_GOAL, "no goal has been given");
    return true;
  }
  const auto robot = robotPlace();
  if (!robot) {
    if (may_wait) return false;
    refuse(PlanStatus::START_BLOCKED, "tf", robot.error());
    return true;
  }
  stamps_.take(stamp);
  fixGoal();
  const auto goal = planner_.locate(*goal_);
  if (!goal) {
    refuse(PlanStatus::NO_GOAL, "goal", goal.error());
    return true;
  }
  auto begin = Clock::now();
  const std::string error = planner_.takeIn();
  times_.obstacles = Clock::now() - begin;
  if (!error.empty()) {
    refuse(PlanStatus::NO_POLYGONS, "polygons", error);
    return true;
  }
  begin = Clock::now();
  planner_.makePlan(*robot, *goal, parameters_.path.goal_tolerance, plan_);
  planner_.keepSide(parameters_.fixed_frame, parameters_.path, *goal, plan_);
  times_.search = Clock::now() - begin;
  goal_yaw_ = goal->yaw;
  publish(statusOf(plan_.outcome), textOf(plan_));
  return true;
}

void PlanMaker::publish(std::uint8_t status, const std::string& message)
{
  const auto start = Clock::now();
  outputs_.publish({planner_.polygons()->header, status, message, plan_, goal_yaw_, planner_.search()});
  statistics_.answered(times_, Clock::now() - start);
  times_ = PlanTimes();
}

void PlanMaker::refuse(std::uint8_t status, const char* kind, const std::string& reason)
{
  statistics_.rejected(reason);
  log_.error(kind, reason);
  outputs_.publish({planner_.polygons()->header, status, reason, plan_, goal_yaw_, planner_.search()});
}

void PlanMaker::setGoal(const geometry_msgs::PoseStamped& goal)
{
  const auto& p = goal.pose.position;
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
    log_.error("goal", "goal: pose.position is not finite, accepted are numbers");
    return;
  }
  if (const std::string error = ros_common::frameIdError(goal.header.frame_id); !error.empty()) {
    log_.error("goal", "goal: " + error);
    return;
  }
  goal_ = goal;
  is_goal_fixed_ = goal.header.frame_id == parameters_.fixed_frame;
}

void PlanMaker::fixGoal()
{
  if (is_goal_fixed_) return;
  const ros::Time& stamp = goal_->header.stamp;
  const auto moved = planner_.moved(*goal_, parameters_.fixed_frame, stamp.isZero() ? newestStamp() : stamp);
  if (!moved) return;
  goal_ = *moved;
  is_goal_fixed_ = true;
}

ros_common::Expected<PolygonPlanner::Place> PlanMaker::robotPlace() const
{
  geometry_msgs::PoseStamped origin;
  origin.header.frame_id = parameters_.robot_frame;
  return planner_.locate(origin);
}

nav_msgs::Path PlanMaker::makePlan(const geometry_msgs::PoseStamped& start,
                                   const geometry_msgs::PoseStamped& goal, double tolerance)
{
  nav_msgs::Path none;
  const auto refused = [&](const std::string& reason) {
    log_.warn("make_plan", "make_plan: " + reason);
    return none;
  };
  if (!planner_.polygons()) return refused("no polygons have come");
  none.header = planner_.polygons()->header;
  const auto from = planner_.locate(start);
  if (!from) return refused(from.error());
  const auto to = planner_.locate(goal);
  if (!to) return refused(to.error());
  if (const std::string error = planner_.takeIn(); !error.empty()) return refused(error);
  planning::Plan plan;
  planner_.makePlan(*from, *to, tolerance > 0.0 ? tolerance : parameters_.path.goal_tolerance, plan);
  if (plan.outcome != planning::PlanOutcome::kOk) return refused(textOf(plan));
  return toPath(planner_.polygons()->header, plan.path, to->yaw);
}

void PlanMaker::configure(const ShortestPathParameters& parameters)
{
  parameters_ = parameters;
  planner_.setOutsideIsFree(parameters.path.outsideIsFree());
}

void PlanMaker::resetTime(const std::string& reason)
{
  log_.warn("time", "time has jumped back (" + reason + "): goal and polygons are forgotten");
  planner_.forget();
  goal_.reset();
  stamps_.reset();
}

}  // namespace polygonal_perception::ros_planning

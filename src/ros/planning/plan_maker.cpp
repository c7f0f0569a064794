#include "ros/planning/plan_maker.hpp"

#include <polygonal_perception/PlanStatus.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "polygonal_perception/ros/common/marker_parts.hpp"
#include "polygonal_perception/ros/common/polygon_messages.hpp"
#include "polygonal_perception/ros/common/text_rules.hpp"

namespace polygonal_perception::ros_planning {

namespace {

using Clock = ros_common::FrameStatistics::Clock;

std::uint8_t statusOf(planning::PlanOutcome outcome)
{
  switch (outcome) {
    case planning::PlanOutcome::kOk:
      return PlanStatus::OK;
    case planning::PlanOutcome::kNoPolygons:
      return PlanStatus::NO_POLYGONS;
    case planning::PlanOutcome::kStartBlocked:
      return PlanStatus::START_BLOCKED;
    case planning::PlanOutcome::kGoalBlocked:
      return PlanStatus::GOAL_BLOCKED;
    case planning::PlanOutcome::kUnreachable:
      return PlanStatus::UNREACHABLE;
    case planning::PlanOutcome::kOutside:
      break;
  }
  return PlanStatus::OUTSIDE;
}

std::string detourText(double detour)
{
  if (detour <= 0.0) return "";
  char text[80];
  std::snprintf(text, sizeof text, ", %.2f m longer than the shortest to stay on its side", detour);
  return text;
}

std::string textOf(const planning::Plan& plan)
{
  char text[160];
  switch (plan.outcome) {
    case planning::PlanOutcome::kOk:
      std::snprintf(text, sizeof text, "a path of %.2f m%s%s", plan.length,
                    plan.start_shift > 0.0 ? ", out of an obstacle" : "",
                    plan.goal_shift > 0.0 ? ", to the free point nearest to the goal" : "");
      return text + detourText(plan.detour);
    case planning::PlanOutcome::kNoPolygons:
      return "no polygons to plan on";
    case planning::PlanOutcome::kStartBlocked:
      return "the robot is inside an obstacle that has no free border";
    case planning::PlanOutcome::kGoalBlocked:
      return "the goal is inside an obstacle, and no free point is within the tolerance";
    case planning::PlanOutcome::kUnreachable:
      return "there is no way to the goal";
    case planning::PlanOutcome::kOutside:
      break;
  }
  return "the robot or the goal is beyond what was looked at";
}

double yawOf(const Eigen::Matrix3d& rotation)
{
  return std::atan2(rotation(1, 0), rotation(0, 0));
}

bool hasOrientation(const geometry_msgs::Pose& pose)
{
  const auto& q = pose.orientation;
  return std::abs(q.x) + std::abs(q.y) + std::abs(q.z) + std::abs(q.w) > 0.0;
}

Eigen::Isometry3d toIsometry(const geometry_msgs::Pose& pose)
{
  const auto& q = pose.orientation;
  const Eigen::Quaterniond rotation(q.w, q.x, q.y, q.z);
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  if (hasOrientation(pose)) result.linear() = rotation.normalized().toRotationMatrix();
  result.translation() << pose.position.x, pose.position.y, pose.position.z;
  return result;
}

}  // namespace

PlanMaker::PlanMaker(const ShortestPathParameters& parameters, const PlanOutputs& outputs,
                     ros_common::FrameStatistics& statistics, ros_common::ThrottledLog& log)
    : parameters_(parameters), outputs_(outputs), statistics_(statistics), log_(log)
{
}

bool PlanMaker::process(const PolygonArrayConstPtr& polygons, bool may_wait)
{
  if (const std::string error = ros_common::frameIdError(polygons->header.frame_id); !error.empty()) {
    statistics_.rejected(error);
    log_.error("frame", error);
    return true;
  }
  const ros::Time& stamp = polygons->header.stamp;
  if (stamps_.jumpsBack(stamp)) resetTime("stamps of the polygons");
  if (polygons_ != polygons) {
    polygons_ = polygons;
    are_taken_in_ = false;
  }
  plan_ = planning::Plan();
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
  const auto goal = placeOf(*goal_);
  if (!goal) {
    refuse(PlanStatus::NO_GOAL, "goal", goal.error());
    return true;
  }
  if (const std::string error = takeIn(); !error.empty()) {
    refuse(PlanStatus::NO_POLYGONS, "polygons", error);
    return true;
  }
  const auto begin = Clock::now();
  planner_.makePlan(robot->point, goal->point, parameters_.goal_tolerance, plan_);
  keepSide(goal->point);
  times_.search = Clock::now() - begin;
  goal_yaw_ = goal->yaw;
  publish(statusOf(plan_.outcome), textOf(plan_));
  return true;
}

void PlanMaker::keepSide(const Eigen::Vector2d& goal)
{
  // A goal sent again is not quite the same, and one that is a person's place moves.
  const double same_goal = std::max(parameters_.goal_tolerance, 0.05);  // [m]
  const std_msgs::Header& header = polygons_->header;
  Eigen::Isometry3d to_fixed = Eigen::Isometry3d::Identity();
  if (header.frame_id != parameters_.fixed_frame) {
    const auto transform = tf_.lookup(parameters_.fixed_frame, header.frame_id, header.stamp);
    if (!transform) return guide_.clear();
    to_fixed = *transform;
  }
  const auto move = [this](const Eigen::Isometry3d& transform) {
    for (Eigen::Vector2d& p : guide_) p = (transform * Eigen::Vector3d(p.x(), p.y(), 0.0)).head<2>();
  };
  move(to_fixed.inverse());
  if (!guide_.empty() && (guide_.back() - goal).norm() > same_goal) guide_.clear();
  planner_.keepSide(parameters_.side_hysteresis, guide_, plan_);
  move(to_fixed);
}

void PlanMaker::publish(std::uint8_t status, const std::string& message)
{
  const auto start = Clock::now();
  outputs_.publish({polygons_->header, status, message, plan_, goal_yaw_, planner_.search()});
  statistics_.answered(times_, Clock::now() - start);
  times_ = PlanTimes();
}

void PlanMaker::refuse(std::uint8_t status, const char* kind, const std::string& reason)
{
  statistics_.rejected(reason);
  log_.error(kind, reason);
  outputs_.publish({polygons_->header, status, reason, plan_, goal_yaw_, planner_.search()});
}

std::string PlanMaker::takeIn()
{
  if (are_taken_in_) return fault_;
  are_taken_in_ = true;
  fault_.clear();
  const auto start = Clock::now();
  if (polygons_->floor_status == FloorPlane::NOT_FOUND && polygons_->polygons.empty()) {
    fault_ = "without a floor nobody knows what stands where";
    return fault_;
  }
  const auto obstacles = ros_common::toPolygonSet(*polygons_);
  if (!obstacles) return fault_ = obstacles.error();
  const auto refused = planner_.setObstacles(*obstacles, ros_common::toVertices(polygons_->extent),
                                             parameters_.outsideIsFree());
  if (refused) fault_ = "polygons: " + refused->text;
  times_.obstacles = Clock::now() - start;
  return fault_;
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
  const auto transform =
      tf_.lookup(parameters_.fixed_frame, goal_->header.frame_id, stamp.isZero() ? newestStamp() : stamp);
  if (!transform) return;
  const Eigen::Isometry3d pose = *transform * toIsometry(goal_->pose);
  goal_->header.frame_id = parameters_.fixed_frame;
  goal_->pose.position = ros_common::point(pose.translation());
  is_goal_fixed_ = true;
  if (!hasOrientation(goal_->pose)) return;
  const Eigen::Quaterniond rotation(pose.linear());
  goal_->pose.orientation.x = rotation.x();
  goal_->pose.orientation.y = rotation.y();
  goal_->pose.orientation.z = rotation.z();
  goal_->pose.orientation.w = rotation.w();
}

ros_common::Expected<PlanMaker::Place> PlanMaker::placeOf(const geometry_msgs::PoseStamped& pose) const
{
  Eigen::Isometry3d place = toIsometry(pose.pose);
  const std::string& frame = pose.header.frame_id;
  if (!frame.empty() && frame != polygons_->header.frame_id) {
    const auto transform = tf_.lookup(polygons_->header.frame_id, frame, polygons_->header.stamp);
    if (!transform) return ros_common::Expected<Place>::failure(transform.error());
    place = *transform * place;
  }
  Place in_frame{place.translation().head<2>(), std::nullopt};
  if (hasOrientation(pose.pose)) in_frame.yaw = yawOf(place.linear());
  return in_frame;
}

ros_common::Expected<PlanMaker::Place> PlanMaker::robotPlace() const
{
  geometry_msgs::PoseStamped origin;
  origin.header.frame_id = parameters_.robot_frame;
  return placeOf(origin);
}

nav_msgs::Path PlanMaker::makePlan(const geometry_msgs::PoseStamped& start,
                                   const geometry_msgs::PoseStamped& goal, double tolerance)
{
  nav_msgs::Path none;
  const auto refused = [&](const std::string& reason) {
    log_.warn("make_plan", "make_plan: " + reason);
    return none;
  };
  if (!polygons_) return refused("no polygons have come");
  none.header = polygons_->header;
  const auto from = placeOf(start);
  if (!from) return refused(from.error());
  const auto to = placeOf(goal);
  if (!to) return refused(to.error());
  if (const std::string error = takeIn(); !error.empty()) return refused(error);
  planning::Plan plan;
  planner_.makePlan(from->point, to->point, tolerance > 0.0 ? tolerance : parameters_.goal_tolerance, plan);
  if (plan.outcome != planning::PlanOutcome::kOk) return refused(textOf(plan));
  return toPath(polygons_->header, plan.path, to->yaw);
}

void PlanMaker::configure(const ShortestPathParameters& parameters)
{
  are_taken_in_ = are_taken_in_ && parameters.outside == parameters_.outside;
  parameters_ = parameters;
}

void PlanMaker::resetTime(const std::string& reason)
{
  log_.warn("time", "time has jumped back (" + reason + "): goal and polygons are forgotten");
  tf_.clear();
  goal_.reset();
  guide_.clear();
  polygons_.reset();
  stamps_.reset();
}

}  // namespace polygonal_perception::ros_planning

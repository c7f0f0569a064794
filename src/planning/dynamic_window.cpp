#include "polygonal_perception/planning/dynamic_window.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planning/surroundings.hpp"
#include "polygonal_perception/geometry/angle.hpp"

namespace polygonal_perception::planning {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// [s] The velocity follows a command in steps no longer than this. A base may do so, too; one that does so smoothly is no
// farther away than a step's change of speed times half a step: 0.5 mm at 10 m/s^2.
constexpr double kRampStep = 0.01;
// [m] Braking among what moves is a chain of arcs, each with its mean speed, on which the robot is beside its place at that
// time by no more than this.
constexpr double kBrakingError = 5e-4;
// [m] So far out of an obstacle a robot wants to get that stands in it: borders move by a cell from frame to frame.
constexpr double kBeyond = 0.1;
// How many places of an arc are looked at: the robot may leave it in each of them.
constexpr int kPlaces = 10;

double wrapped(double angle)
{
  return std::remainder(angle, geometry::kTwoPi);
}

/// Where a component of the velocity is looked at: from the least to the greatest, 0 and the present one included.
void sample(double low, double high, int count, double present, std::vector<double>& values)
{
  values.clear();
  for (int i = 0; i < count; ++i) values.push_back(low + (high - low) * i / std::max(1, count - 1));
  values.push_back(0.0);
  values.push_back(std::clamp(present, low, high));
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

double meanOf(double value, double target, double limit, double duration)
{
  const double ramp = limit > 0.0 ? std::abs(target - value) / limit : 0.0;
  if (ramp <= duration) return target - 0.5 * (target - value) * ramp / duration;
  return value + std::copysign(0.5 * limit * duration, target - value);
}

}  // namespace

DriveDecision DynamicWindow::decide(const RobotState& state, const std::vector<MovingEdge>& standing,
                                    const std::vector<MovingEdge>& moving,
                                    const std::vector<Eigen::Vector2d>& path, double goal_yaw, double period)
{
  tried_.clear();
  chosen_.reset();
  path_.setPath(path);
  lookAround(state, standing, moving, period);
  if ((path_.goal() - state.pose.position).norm() <= parameters_.xy_goal_tolerance)
    return turnOrStand(state, goal_yaw, period);

  DriveDecision best;
  best.command = brake(state.velocity, period);
  if (is_run_over_) return best;
  // First of all out of an obstacle, by the shortest way and a little farther.
  if (is_inside_) path_.setPath(state.pose.position, state.pose.position + (depth_ + kBeyond) * outward_);
  double least = kInfinity;
  chooseTargets(state.velocity);
  // Slow enough to stop at the goal.
  const double rest = path_.from(state.pose.position, 0.0).length;
  const RobotModel& robot = parameters_.robot;
  const double braking = robot.max_vel_y > 0.0 ? std::min(robot.acc_lim_x, robot.acc_lim_y) : robot.acc_lim_x;
  const double approach = std::sqrt(2.0 * braking * rest);
  for (const Twist& target : targets_) {
    if (target.speed() > approach) continue;
    const Followed followed = follow(state, target, period);
    if (!followed.is_safe) continue;
    const Arc arc(state.pose, mean(state.velocity, target, parameters_.sim_time));
    const double contact = timeToCollision(arc);
    const double duration =
        std::max(0.0, std::min(parameters_.sim_time, contact - 0.5 * parameters_.robot.brakingTime(target)));
    tried_.push_back({arc, duration});
    const double value = cost(arc, duration) + changeCost(state.velocity, target);
    if (!(value < least)) continue;
    least = value;
    best.outcome = DriveDecision::Outcome::kDriving;
    best.command = target;
    chosen_ = tried_.back();
    best.time_to_collision = contact;
  }
  if (best.outcome == DriveDecision::Outcome::kDriving) {
    // What it reaches within the period: a base that knows no limits must not do more.
    best.command = parameters_.robot.follow(state.velocity, best.command, period);
  }
  return best;
}

void DynamicWindow::lookAround(const RobotState& state, const std::vector<MovingEdge>& standing,
                               const std::vector<MovingEdge>& moving, double period)
{
  const RobotModel& robot = parameters_.robot;
  const auto greater = [](double low, double high, double present) {
    return std::max({high, -low, std::abs(present)});
  };
  const Twist fastest{greater(robot.min_vel_x, robot.max_vel_x, state.velocity.x),
                      greater(robot.min_vel_y, robot.max_vel_y, state.velocity.y),
                      greater(-robot.max_vel_theta, robot.max_vel_theta, state.velocity.theta)};
  // Until the end of the longest way to stop, which is not asked for where a component cannot be braked.
  const double braking = robot.brakingTime(fastest);
  const double horizon =
      std::max(parameters_.sim_time,
               period + (braking < kInfinity ? braking : robot.brakingTime({fastest.x, 0.0, fastest.theta})));
  const double reach = fastest.speed() * horizon;
  standing_.setEdges(standing, state.pose.position, reach, horizon);
  moving_.setEdges(moving, state.pose.position, reach, horizon);
  const Surroundings around = surroundings(state.pose.position, standing);
  depth_ = around.depth;
  is_inside_ = depth_ > ContactSearch::kAtBorder;
  outward_ = around.outward;
  is_run_over_ = surroundings(state.pose.position, moving).depth > ContactSearch::kAtBorder;
}

void DynamicWindow::chooseTargets(const Twist& velocity)
{
  const Parameters& p = parameters_;
  auto& [x, y, theta] = samples_;
  sample(p.robot.min_vel_x, p.robot.max_vel_x, p.vx_samples, velocity.x, x);
  sample(p.robot.min_vel_y, p.robot.max_vel_y, p.robot.max_vel_y > p.robot.min_vel_y ? p.vy_samples : 1,
         velocity.y, y);
  sample(-p.robot.max_vel_theta, p.robot.max_vel_theta, p.vth_samples, velocity.theta, theta);
  targets_.clear();
  for (const double vx : x)
    for (const double vy : y)
      for (const double w : theta) targets_.push_back({vx, vy, w});
}

DynamicWindow::Followed DynamicWindow::follow(const RobotState& state, const Twist& command,
                                              double period) const
{
  Followed result{state.pose, state.velocity, true};
  const int steps = static_cast<int>(std::ceil(period / kRampStep));
  const double step = period / steps;
  for (int i = 0; i < steps && result.is_safe; ++i) {
    result.velocity = parameters_.robot.follow(result.velocity, command, step);
    const Arc arc(result.pose, result.velocity, i * step);
    const double end = (i + 1) * step;
    result.is_safe = isFree(arc, end) && (!is_inside_ || leadsOut(arc, end));
    result.pose = arc.pose(end);
  }
  result.is_safe = result.is_safe && canStop(result.pose, result.velocity, period);
  return result;
}

bool DynamicWindow::canStop(const Pose& pose, const Twist& velocity, double begin) const
{
  const double duration = parameters_.robot.brakingTime(velocity);
  if (!(duration < kInfinity)) return false;
  // Along the arc as far as in half of that time without braking.
  const Arc arc(pose, velocity, begin);
  const double until = begin + 0.5 * duration;
  if (standing_.firstContact(arc, until)) return false;
  if (is_inside_ && !leadsOut(arc, until)) return false;
  if (moving_.isEmpty()) return true;
  // With a deceleration a it is beside by a t^2 / 8 in the middle of an arc of duration t.
  const double arcs =
      std::max(1.0, std::ceil(std::sqrt(velocity.speed() * duration / (8.0 * kBrakingError))));
  Pose at = pose;
  for (double i = 0.0; i < arcs; ++i) {
    const double share = 1.0 - (i + 0.5) / arcs;
    const Arc part(at, {share * velocity.x, share * velocity.y, share * velocity.theta},
                   begin + duration * i / arcs);
    const double end = begin + duration * (i + 1.0) / arcs;
    if (moving_.firstContact(part, end)) return false;
    at = part.pose(end);
  }
  return true;
}

bool DynamicWindow::isFree(const Arc& arc, double until) const
{
  return !standing_.firstContact(arc, until) && !moving_.firstContact(arc, until);
}

bool DynamicWindow::leadsOut(const Arc& arc, double until) const
{
  if (arc.speed() == 0.0) return true;
  const double turn = arc.turnRate() * (until - arc.begin());
  const Eigen::Vector2d end(std::cos(turn) * arc.direction().x() - std::sin(turn) * arc.direction().y(),
                            std::sin(turn) * arc.direction().x() + std::cos(turn) * arc.direction().y());
  return std::abs(turn) < geometry::kPi && outward_.dot(arc.direction()) >= 0.0 && outward_.dot(end) >= 0.0;
}

Twist DynamicWindow::mean(const Twist& velocity, const Twist& target, double duration) const
{
  const RobotModel& robot = parameters_.robot;
  return {meanOf(velocity.x, target.x, robot.acc_lim_x, duration),
          meanOf(velocity.y, target.y, robot.acc_lim_y, duration),
          meanOf(velocity.theta, target.theta, robot.acc_lim_theta, duration)};
}

double DynamicWindow::cost(const Arc& arc, double duration) const
{
  double least = kInfinity;
  for (int i = 0; i <= kPlaces; ++i) {
    const double time = duration * i / kPlaces;
    least = std::min(least, time + parameters_.progress_scale * timeToGo(arc.pose(time)));
  }
  return least;
}

double DynamicWindow::changeCost(const Twist& velocity, const Twist& target) const
{
  const RobotModel& robot = parameters_.robot;
  const auto share = [](double change, double limit) { return limit > 0.0 ? std::abs(change) / limit : 0.0; };
  return parameters_.smoothness_scale *
         (share(target.x - velocity.x, robot.max_vel_x) + share(target.y - velocity.y, robot.max_vel_y) +
          share(target.theta - velocity.theta, robot.max_vel_theta));
}

double DynamicWindow::timeToGo(const Pose& pose) const
{
  const RobotModel& robot = parameters_.robot;
  const RemainingPath::Way way = path_.from(pose.position, parameters_.heading_lookahead);
  const Eigen::Vector2d ahead = way.ahead - pose.position;
  const double angle = std::abs(wrapped(std::atan2(ahead.y(), ahead.x()) - pose.yaw));
  double least = kInfinity;
  const auto turnAndDrive = [&](double turn, double speed) {
    if (speed > 0.0 && robot.max_vel_theta > 0.0)
      least = std::min(least, turn / robot.max_vel_theta + way.length / speed);
  };
  turnAndDrive(angle, robot.max_vel_x);
  turnAndDrive(geometry::kPi - angle, -robot.min_vel_x);
  turnAndDrive(std::abs(angle - 0.5 * geometry::kPi), std::min(robot.max_vel_y, -robot.min_vel_y));
  return least;
}

double DynamicWindow::timeToCollision(const Arc& arc) const
{
  const auto standing = standing_.firstContact(arc, parameters_.sim_time);
  const auto moving = moving_.firstContact(arc, standing.value_or(parameters_.sim_time));
  return moving ? *moving : standing.value_or(kInfinity);
}

Twist DynamicWindow::brake(const Twist& velocity, double period) const
{
  const double duration = parameters_.robot.brakingTime(velocity);
  if (duration <= period) return {};
  const double share = 1.0 - period / duration;
  return {share * velocity.x, share * velocity.y, share * velocity.theta};
}

DriveDecision DynamicWindow::turnOrStand(const RobotState& state, double goal_yaw, double period)
{
  const RobotModel& robot = parameters_.robot;
  DriveDecision decision;
  decision.time_to_collision = kInfinity;
  const double turn = wrapped(goal_yaw - state.pose.yaw);
  if (std::abs(turn) <= parameters_.yaw_goal_tolerance) {
    decision.outcome = DriveDecision::Outcome::kArrived;
    decision.command = brake(state.velocity, period);
    return decision;
  }
  // On the spot, no faster than it can stop in time.
  const double rate = std::min(robot.max_vel_theta, std::sqrt(2.0 * robot.acc_lim_theta * std::abs(turn)));
  const Twist still = brake({state.velocity.x, state.velocity.y, 0.0}, period);
  const Twist command = robot.follow(state.velocity, {still.x, still.y, std::copysign(rate, turn)}, period);
  const bool is_safe = follow(state, command, period).is_safe;
  decision.outcome = is_safe ? DriveDecision::Outcome::kDriving : DriveDecision::Outcome::kBlocked;
  decision.command = is_safe ? command : brake(state.velocity, period);
  return decision;
}

}  // namespace polygonal_perception::planning

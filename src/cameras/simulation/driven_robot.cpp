#include "polygonal_perception/cameras/simulation/driven_robot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polygonal_perception::simulation {

namespace {

constexpr double kTimeStep = 0.01;  // [s]
// [m] Between these heights there is robot.
constexpr double kLow = 0.03;
constexpr double kHigh = 1.0;
constexpr double kApart = 0.02;   // [m] farther away it may bump again
constexpr double kStands = 0.05;  // [m/s] slower than that it stands

std::vector<Outline> outlinesOf(const std::vector<Solid>& solids)
{
  std::vector<Outline> outlines;
  for (const Solid& solid : solids) {
    if (solid.surface != Surface::kObstacle) continue;
    Outline outline = footprint(solid, kLow, kHigh);
    if (outline.size() >= 3) outlines.push_back(std::move(outline));
  }
  return outlines;
}

double nearest(const std::vector<Outline>& outlines, const Eigen::Vector2d& position)
{
  double least = std::numeric_limits<double>::infinity();
  for (const Outline& outline : outlines) least = std::min(least, distanceTo(outline, position));
  return least;
}

}  // namespace

DrivenRobot::DrivenRobot(const Scene& scene, std::uint64_t seed, const Parameters& parameters)
    : scene_(&scene), parameters_(parameters), standing_(outlinesOf(scene.solids))
{
  const auto robotino = makeTrajectory("robotino", scene, seed);
  const Eigen::Isometry3d base = robotino->base(0.0);
  start_.pose = {base.translation().head<2>(), std::atan2(base(1, 0), base(0, 0))};
  camera_ = base.inverse() * robotino->pose(0.0);
  state_ = start_;
}

void DrivenRobot::command(const planning::Twist& twist)
{
  given_.push_back({now_ + parameters_.latency, parameters_.model.clamped(twist)});
}

void DrivenRobot::advanceTo(double time)
{
  if (time < now_) {
    state_ = start_;
    now_ = 0.0;
    given_.clear();
    is_touching_ = false;
  }
  while (now_ < time) step(std::min(kTimeStep, time - now_));
}

void DrivenRobot::step(double duration)
{
  while (given_.size() > 1 && given_[1].effect <= now_) given_.pop_front();
  const bool holds =
      !given_.empty() && given_[0].effect <= now_ && now_ <= given_[0].effect + parameters_.command_timeout;
  const planning::RobotState next =
      parameters_.model.advanced(state_, holds ? given_[0].twist : planning::Twist(), duration);
  state_.velocity = next.velocity;
  now_ += duration;

  const double before = clearance(state_.pose.position);
  const double after = clearance(next.pose.position);
  const bool touches = after < 0.0;
  const bool drives = state_.velocity.speed() >= kStands;
  if (touches && drives && !is_touching_) ++bumps_;
  is_touching_ = touches || (is_touching_ && after < kApart);
  state_.pose.yaw = next.pose.yaw;
  if (touches && after < before) {
    // It pushes, and nothing gives way.
    state_.velocity.x = state_.velocity.y = 0.0;
    return;
  }
  state_.pose.position = next.pose.position;
}

double DrivenRobot::clearance(const Eigen::Vector2d& position) const
{
  std::vector<Solid> people;
  scene_->walkersAt(now_, people);
  return std::min(nearest(standing_, position), nearest(outlinesOf(people), position)) - parameters_.radius;
}

Eigen::Isometry3d DrivenRobot::base(double /*time*/) const
{
  Eigen::Isometry3d base = Eigen::Isometry3d::Identity();
  base.linear() = Eigen::AngleAxisd(state_.pose.yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  base.translation() << state_.pose.position, 0.0;
  return base;
}

}  // namespace polygonal_perception::simulation

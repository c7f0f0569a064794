#include "ros/driving/driver.hpp"

#include <polygonal_perception/FloorPlane.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace polygonal_perception::ros_driving {

using planning::DriveDecision;
using planning::MovingEdge;
using planning::Twist;

namespace {

constexpr double kStep = 0.01;      // [s] of a prediction
constexpr double kRounding = 1e-6;  // [s] of a clock in seconds since 1970: a double has 2e-7

std::string textOf(const DriveDecision& decision)
{
  switch (decision.outcome) {
    case DriveDecision::Outcome::kDriving:
      return "driving";
    case DriveDecision::Outcome::kArrived:
      return "at the goal";
    case DriveDecision::Outcome::kBlocked:
      break;
  }
  return "no motion is safe";
}

std::uint8_t statusOf(DriveDecision::Outcome outcome)
{
  switch (outcome) {
    case DriveDecision::Outcome::kDriving:
      return DriveStatus::DRIVING;
    case DriveDecision::Outcome::kArrived:
      return DriveStatus::ARRIVED;
    case DriveDecision::Outcome::kBlocked:
      break;
  }
  return DriveStatus::BLOCKED;
}

}  // namespace

void Driver::configure(const DynamicWindowParameters& parameters)
{
  parameters_ = parameters;
  window_.configure(parameters.driving);
}

DriveReport Driver::tick(const ros::Time& now)
{
  DriveReport report = drive(now);
  report.header.stamp = now;
  if (odometry_) report.header.frame_id = odometry_->header.frame_id;
  sent_.push_back({now.toSec() + parameters_.latency, report.command});
  // The last one that holds is still of use.
  while (sent_.size() > 1 && odometry_ && sent_[1].effect <= odometry_->header.stamp.toSec())
    sent_.pop_front();
  constexpr std::size_t kMostSent = 1000;
  if (sent_.size() > kMostSent) sent_.pop_front();
  return report;
}

DriveReport Driver::drive(const ros::Time& now)
{
  if (const std::string error = stale(now); !error.empty()) return stopping(now, DriveStatus::STALE, error);
  if (polygons_->floor_status == FloorPlane::NOT_FOUND)
    return stopping(now, DriveStatus::NO_FLOOR, "the polygons say that no floor was found");
  if (!path_ || path_->poses.empty())
    return stopping(now, DriveStatus::NO_PATH, path_ ? "the path is empty" : "no path has come");

  const std::string& frame = odometry_->header.frame_id;
  const auto state = DriveInputs::state(*odometry_);
  if (!state) return refusing(now, DriveStatus::STALE, state.error());
  const auto standing = inputs_.standing(*polygons_, frame);
  if (!standing) return refusing(now, DriveStatus::STALE, standing.error());
  const auto path = inputs_.path(*path_, frame);
  if (!path) return refusing(now, DriveStatus::NO_PATH, path.error());
  const double effect = now.toSec() + parameters_.latency;
  std::vector<MovingEdge> moving;
  if (tracked_) {
    const auto edges = inputs_.moving(*tracked_, parameters_.velocity_sigmas, frame);
    if (!edges) return refusing(now, DriveStatus::STALE, edges.error());
    const double age = std::max(0.0, effect - tracked_->header.stamp.toSec());
    for (const MovingEdge& edge : *edges) moving.push_back(planning::advanced(edge, age));
  }

  const planning::RobotState at_effect = predicted(*state, odometry_->header.stamp.toSec(), effect);
  const DriveDecision decision =
      window_.decide(at_effect, *standing, moving, path->points, path->goal_yaw, period());
  DriveReport report;
  report.command = decision.command;
  report.status = statusOf(decision.outcome);
  report.message = textOf(decision);
  report.time_to_collision = decision.time_to_collision;
  return report;
}

std::string Driver::stale(const ros::Time& now) const
{
  const auto error = [&](const char* none, const char* old, const auto& message) -> std::string {
    if (!message) return none;
    if (!isOld(message->header.stamp, now)) return {};
    char text[100];
    std::snprintf(text, sizeof text, "%s of %.2f s ago", old, now.toSec() - message->header.stamp.toSec());
    return text;
  };
  std::string text = error("no odometry has come", "the odometry is", odometry_);
  if (text.empty()) text = error("no polygons have come", "the polygons are", polygons_);
  if (text.empty() && tracked_) text = error("", "the tracked_polygons are", tracked_);
  return text;
}

bool Driver::isOld(const ros::Time& stamp, const ros::Time& now) const
{
  return std::abs(now.toSec() - stamp.toSec()) > parameters_.timeout;
}

planning::RobotState Driver::predicted(planning::RobotState state, double time, double end) const
{
  std::size_t next = 0;
  Twist command = state.velocity;
  while (end - time > kRounding) {
    for (; next < sent_.size() && sent_[next].effect <= time + kRounding; ++next) command = sent_[next].twist;
    double step = std::min(kStep, end - time);
    if (next < sent_.size()) step = std::min(step, std::max(kRounding, sent_[next].effect - time));
    state = parameters_.driving.robot.advanced(state, command, step);
    time += step;
  }
  return state;
}

DriveReport Driver::stopping(const ros::Time& now, std::uint8_t status, const std::string& message) const
{
  DriveReport report;
  report.status = status;
  report.message = message;
  report.time_to_collision = std::numeric_limits<double>::infinity();
  // What it does now, as far as that is known.
  Twist velocity = sent_.empty() ? Twist() : sent_.back().twist;
  if (odometry_ && !isOld(odometry_->header.stamp, now))
    if (const auto state = DriveInputs::state(*odometry_)) velocity = state->velocity;
  report.command = window_.brake(velocity, period());
  return report;
}

DriveReport Driver::refusing(const ros::Time& now, std::uint8_t status, const std::string& message) const
{
  DriveReport report = stopping(now, status, message);
  report.is_refusal = true;
  return report;
}

void Driver::reset()
{
  inputs_.clear();
  polygons_.reset();
  tracked_.reset();
  path_.reset();
  odometry_.reset();
  sent_.clear();
}

}  // namespace polygonal_perception::ros_driving

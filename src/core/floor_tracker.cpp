#include "polygonal_perception/floor_tracker.hpp"

#include <algorithm>

namespace polygonal_perception {

namespace {

/// How long after it was last seen the floor's height still says something about the camera's.
constexpr double kHeightMemory = 3.0;         // [s]
constexpr double kHeightTolerance = 0.06;     // [m] from one frame to the next
constexpr double kVerticalSpeed = 0.5;        // [m/s] of a camera in somebody's hand
/// A drop was in view with the last floor: what lies there is still no floor when the robot's own is out of view.
constexpr double kHeightMemoryAtDrop = 20.0;  // [s]
constexpr double kVerticalSpeedAtDrop = 0.1;  // [m/s]
/// Frames in a row that must have shown the same floor before a lower plane counts as a drop beyond it.
constexpr int kFirmAfter = 3;

}  // namespace

void FloorTracker::configure(const Parameters& parameters, const FloorDetector::Parameters& detector)
{
  parameters_ = parameters;
  detector_ = FloorDetector(detector);
}

void FloorTracker::reset()
{
  state_ = FloorState{};
  found_stamp_.reset();
  last_stamp_.reset();
  streak_ = 0;
}

FloorPrior FloorTracker::prior(double stamp, const std::optional<Eigen::Vector3d>& up_from_tf) const
{
  FloorPrior prior;
  const bool known = state_.status != FloorStatus::kNotFound;
  if (parameters_.up_feedback && known) {
    prior.up = state_.floor.plane.normal;
    prior.up_is_measured = true;
  } else if (up_from_tf) {
    prior.up = up_from_tf->normalized();
    prior.up_is_measured = true;
  } else {
    prior.up = parameters_.initial_up.normalized();
  }
  if (!found_stamp_) return prior;

  const double unseen = stamp - *found_stamp_;
  const bool at_drop = state_.floor.drop_in_view;
  if (unseen < (at_drop ? kHeightMemoryAtDrop : kHeightMemory)) {
    prior.height = state_.floor.plane.distance;
    prior.height_tolerance = kHeightTolerance + (at_drop ? kVerticalSpeedAtDrop : kVerticalSpeed) * unseen;
    prior.firm = streak_ >= kFirmAfter;
  }
  return prior;
}

const FloorState& FloorTracker::update(const PointView& points, const SampleGrid& grid, double stamp,
                                       const std::optional<Eigen::Vector3d>& up_from_tf)
{
  if (last_stamp_ && stamp < *last_stamp_) reset();
  last_stamp_ = stamp;
  // What was held too long is given up before the frame is looked at, so that the frame starts from the seed.
  if (state_.status != FloorStatus::kNotFound && stamp - *found_stamp_ > parameters_.floor_timeout) {
    state_.status = FloorStatus::kNotFound;
  }

  if (const auto floor = detector_.detect(points, grid, prior(stamp, up_from_tf))) {
    streak_ = floor->continued ? std::min(streak_ + 1, kFirmAfter) : 1;
    state_ = {FloorStatus::kFound, *floor, 0.0};
    found_stamp_ = stamp;
  } else if (state_.status != FloorStatus::kNotFound) {
    state_.status = FloorStatus::kHeld;
    state_.age = stamp - *found_stamp_;
  }
  return state_;
}

}  // namespace polygonal_perception

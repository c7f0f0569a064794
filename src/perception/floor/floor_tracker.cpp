#include "polygonal_perception/perception/floor/floor_tracker.hpp"

#include <algorithm>
#include <cmath>

namespace polygonal_perception::perception {

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
  view_change_.reset();
  forgetView();
}

void FloorTracker::forgetView()
{
  view_is_new_ = true;
  streak_ = 0.0;
  others_.fill(OtherPlane{});
}

FloorPrior FloorTracker::prior(double stamp, const std::optional<Eigen::Vector3d>& up_from_tf) const
{
  FloorPrior prior;
  const bool known = state_.status != FloorStatus::kNotFound && !view_is_new_;
  if (parameters_.up_feedback && known) {
    prior.up = state_.floor.plane.normal;
    prior.up_is_measured = true;
  } else if (up_from_tf) {
    prior.up = up_from_tf->normalized();
    prior.up_is_measured = true;
  } else {
    prior.up = parameters_.initial_up.normalized();
  }
  if (!found_stamp_ || view_is_new_) return prior;

  const double unseen = stamp - *found_stamp_;
  for (const OtherPlane& other : others_) {
    if (stamp - other.stamp < (other.offset < 0.0 ? parameters_.drop_memory : parameters_.height_memory))
      prior.others.add(other.offset);
  }
  if (unseen < parameters_.height_memory || prior.others.begin() != prior.others.end()) {
    prior.height = state_.floor.plane.distance;
    prior.height_tolerance = parameters_.height_tolerance + parameters_.vertical_speed * unseen;
    prior.confirmed = streak_ >= parameters_.confirmed_after && known;
  }
  return prior;
}

void FloorTracker::remember(const DetectedFloor& floor, double stamp)
{
  const bool lasts = floor.continued && floor.plane.distance > parameters_.least_confirmed_height;
  streak_ = lasts ? std::min(streak_ + 1.0, parameters_.confirmed_after) : 1.0;
  for (const double offset : floor.others) {
    auto same = std::find_if(others_.begin(), others_.end(), [&](const OtherPlane& other) {
      return std::abs(other.offset - offset) < parameters_.remembered_offset;
    });
    if (same == others_.end()) {
      same = std::min_element(others_.begin(), others_.end(),
                              [](const OtherPlane& a, const OtherPlane& b) { return a.stamp < b.stamp; });
    }
    *same = {offset, stamp};
  }
  state_ = {FloorStatus::kFound, floor, 0.0, std::nullopt};
  view_is_new_ = false;
  found_stamp_ = stamp;
}

const FloorState& FloorTracker::update(const PointView& points, const SampleGrid& grid, double stamp,
                                       const std::optional<Eigen::Vector3d>& up_from_tf)
{
  if (last_stamp_ && stamp < *last_stamp_) reset();
  const bool time_passes = last_stamp_ && stamp > *last_stamp_;
  last_stamp_ = stamp;
  if (view_change_.update(grid, parameters_.view_change)) forgetView();
  // What was held too long is given up before the frame is looked at, so that the frame starts from the seed.
  if (!standsAt(stamp)) state_.status = FloorStatus::kNotFound;

  const FloorPrior known = prior(stamp, up_from_tf);
  if (const auto floor = detector_.detect(points, grid, known)) {
    remember(*floor, stamp);
    return state_;
  }
  state_.absence = detector_.absence(known);
  if (state_.status != FloorStatus::kNotFound && time_passes) {
    state_.status = FloorStatus::kHeld;
    state_.age = stamp - *found_stamp_;
  } else {
    // Where the stamps stand still (a driver that sets none, a clock that stopped) nobody knows how old it
    // is.
    state_.status = FloorStatus::kNotFound;
  }
  return state_;
}

}  // namespace polygonal_perception::perception

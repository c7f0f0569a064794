#include "polygonal_perception/perception/floor/floor_tracker.hpp"

#include <algorithm>
#include <cmath>

#include "polygonal_perception/geometry/angle.hpp"

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
  is_given_up_ = false;
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

FloorPrior FloorTracker::prior(double stamp, const FloorHints& hints) const
{
  FloorPrior prior;
  const bool known = standsAt(stamp) && !view_is_new_;
  prior.level = hints.level;
  if (hints.mount) {
    const FloorMountParameters& mount = parameters_.mount;
    const double slack =
        (mount.has_slopes ? mount.disagreement_sigmas : mount.search_sigmas) * mount.mount_height_sigma;
    prior.up = hints.mount->normal;
    prior.up_is_measured = true;
    prior.tilt_sigma = mount.tilt_about_mount;
    if (mount.has_slopes) prior.max_tilt = mount.disagreement_sigmas * mount.mount_tilt_sigma;
    prior.bounds = HeightBounds{hints.mount->distance - slack, hints.mount->distance + slack};
    prior.level = hints.mount->normal;
  } else if (parameters_.up_feedback && known) {
    prior.up = found_.plane.normal;
    prior.up_is_measured = true;
  } else if (hints.up) {
    prior.up = hints.up->normalized();
    prior.up_is_measured = true;
    prior.level = prior.up;
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
    prior.height = found_.plane.distance;
    prior.height_tolerance = parameters_.height_tolerance + parameters_.vertical_speed * unseen;
    prior.confirmed = streak_ >= parameters_.confirmed_after && known;
    if (known && (parameters_.up_feedback || hints.mount)) {
      prior.last = found_.plane;
    } else if (prior.up_is_measured) {
      prior.last = geometry::Plane{prior.up, *prior.height};
    }
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
  found_ = floor;
  view_is_new_ = false;
  found_stamp_ = stamp;
  is_given_up_ = false;
}

bool FloorTracker::isSameMount(const std::optional<geometry::Plane>& mount) const
{
  if (!mount || !found_mount_) return true;
  return geometry::angleBetween(mount->normal, found_mount_->normal) < parameters_.mount.held_turn &&
         std::abs(mount->distance - found_mount_->distance) < parameters_.mount.held_lift;
}

const FloorState& FloorTracker::update(const PointView& points, const SampleGrid& grid, double stamp,
                                       const FloorHints& hints)
{
  if (last_stamp_ && stamp < *last_stamp_) reset();
  const bool time_passes = last_stamp_ && stamp > *last_stamp_;
  last_stamp_ = stamp;
  if (view_change_.update(grid, parameters_.view_change)) forgetView();
  // What was held too long is given up before the frame is looked at, so that the frame starts from the seed.
  if (!standsAt(stamp)) is_given_up_ = true;

  const FloorPrior known = prior(stamp, hints);
  state_ = FloorState{};
  if (const auto floor = detector_.detect(points, grid, known)) {
    remember(*floor, stamp);
    found_mount_ = hints.mount;
    state_.status = FloorStatus::kFound;
    state_.floor = *floor;
    if (hints.mount) state_.mount_error = mountError(*floor, *hints.mount, parameters_.mount);
    return state_;
  }
  state_.absence = detector_.absence(known);
  // Where the stamps stand still (a driver that sets none, a clock that stopped) nobody knows how old a floor is.
  if (!time_passes) is_given_up_ = true;
  answerWithout(stamp, hints);
  return state_;
}

/// The answer to a frame that shows no floor.
void FloorTracker::answerWithout(double stamp, const FloorHints& hints)
{
  if (standsAt(stamp) && isSameMount(hints.mount)) {
    state_.status = FloorStatus::kHeld;
    state_.floor = found_;
    state_.age = stamp - *found_stamp_;
  } else if (hints.mount && state_.absence->point_share >= parameters_.mount.least_view) {
    state_.status = FloorStatus::kAssumed;
    state_.floor = assumedFloor(*hints.mount, parameters_.mount);
  }
}

}  // namespace polygonal_perception::perception

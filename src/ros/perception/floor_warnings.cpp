#include "ros/perception/floor_warnings.hpp"

#include "polygonal_perception/geometry/angle.hpp"
#include "ros/perception/floor_absence_text.hpp"
#include "ros/perception/mount_error_text.hpp"
#include "ros/perception/printed.hpp"

namespace polygonal_perception::ros_perception {

namespace {

/// Whether a floor is assumed where the mount says while what looks like one lies elsewhere.
bool liesElsewhere(const perception::FloorState& floor)
{
  using Reason = perception::FloorAbsence::Reason;
  if (floor.status != perception::FloorStatus::kAssumed || !floor.absence) return false;
  const Reason reason = floor.absence->reason;
  return reason == Reason::kTooNear || reason == Reason::kTooFar || reason == Reason::kNotLevelInTf;
}

/// Whether a floor is assumed while the largest plane is tilted as a ramp is, or as the floor of a camera that was
/// knocked: where ground may slope nobody can tell them apart.
bool liesTilted(const perception::FloorState& floor)
{
  constexpr double kSteepest = 0.35;  // [rad] more is a wall
  return floor.status == perception::FloorStatus::kAssumed && floor.absence &&
         floor.absence->reason == perception::FloorAbsence::Reason::kNoneFacesUp &&
         floor.absence->tilt < kSteepest;
}

}  // namespace

void FloorWarnings::update(const perception::Pipeline::Result& result, const Eigen::Vector3d& initial_up,
                           const std::string& mount_frame, const ros::Time& stamp)
{
  const perception::FloorState& floor = result.floor;
  const bool is_missing = floor.status == perception::FloorStatus::kNotFound && floor.absence;
  if (missing_.update(is_missing, stamp))
    log_.warn("floor", "no floor for 5 s: " + absenceText(*floor.absence));
  if (elsewhere_.update(liesElsewhere(floor), stamp))
    log_.warn("floor elsewhere", "no floor where mount_frame '" + mount_frame +
                                     "' says for 5 s: " + absenceText(*floor.absence));
  if (tilted_.update(liesTilted(floor), stamp))
    log_.warn("floor tilted",
              printed("no floor where mount_frame '%s' says for 30 s: the largest plane is tilted by %.1f "
                      "degrees; it is a ramp, or the camera has tilted",
                      mount_frame.c_str(), floor.absence->tilt / geometry::kDegree));
  const bool disagrees = floor.mount_error && floor.mount_error->is_beyond;
  if (disagrees_.update(disagrees, stamp))
    log_.warn("mount", mountErrorText(floor, result.view.forward, initial_up, mount_frame));
}

void FloorWarnings::reset()
{
  missing_.reset();
  elsewhere_.reset();
  tilted_.reset();
  disagrees_.reset();
}

}  // namespace polygonal_perception::ros_perception

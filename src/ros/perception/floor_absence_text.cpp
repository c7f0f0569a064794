#include "ros/perception/floor_absence_text.hpp"

#include "polygonal_perception/geometry/angle.hpp"
#include "ros/perception/printed.hpp"

namespace polygonal_perception::ros_perception {

namespace {

}  // namespace

std::string absenceText(const perception::FloorAbsence& absence)
{
  using Reason = perception::FloorAbsence::Reason;
  switch (absence.reason) {
    case Reason::kNoneFacesUp:
      if (absence.up_is_from_tf) {
        return printed(
            "no plane in view faces up as tf has it: the largest faces (%.2f, %.2f, %.2f), %.0f degrees from "
            "that; "
            "if that is the floor, the input's frame_id or tf is wrong",
            absence.normal.x(), absence.normal.y(), absence.normal.z(), absence.tilt / geometry::kDegree);
      }
      return printed(
          "no plane in view faces up: the largest faces (%.2f, %.2f, %.2f), %.0f degrees from the up vector; "
          "if that is "
          "the floor, set initial_up to it",
          absence.normal.x(), absence.normal.y(), absence.normal.z(), absence.tilt / geometry::kDegree);
    case Reason::kNotLevelInTf:
      return printed(
          "the largest plane that faces up is %.0f degrees from level as tf has it: the input's frame_id or "
          "tf is "
          "wrong",
          absence.tilt / geometry::kDegree);
    case Reason::kTooNear:
    case Reason::kTooFar:
      return printed(
          "the camera is %.2f m above the largest plane that faces up, sought is a floor %.2f to %.2f m "
          "below it (%s)",
          absence.height, absence.lowest, absence.highest,
          absence.bounds_are_mounts ? "mount_frame" : "min_camera_height, max_camera_height");
    case Reason::kUnlikely:
      return printed(
          "the largest plane that faces up, %.2f m below the camera, has too much below it or too few pixels "
          "on it",
          absence.height);
    case Reason::kNoPlane:
      break;
  }
  return printed("no plane in view; %.0f %% of the samples have a return", 100.0 * absence.point_share);
}

}  // namespace polygonal_perception::ros_perception

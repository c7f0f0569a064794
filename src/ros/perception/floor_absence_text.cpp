#include "ros/perception/floor_absence_text.hpp"

#include <cstdio>

namespace polygonal_perception::ros_perception {

namespace {

constexpr double kDegree = 57.29577951308232;

template <class... Values>
std::string print(const char* format, Values... values)
{
  char text[250];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

}  // namespace

std::string absenceText(const perception::FloorAbsence& absence)
{
  using Reason = perception::FloorAbsence::Reason;
  switch (absence.reason) {
    case Reason::kNoneFacesUp:
      return print(
          "no plane in view faces up: the largest faces (%.2f, %.2f, %.2f), %.0f degrees from the up vector; "
          "if that is "
          "the floor, set initial_up to it",
          absence.normal.x(), absence.normal.y(), absence.normal.z(), absence.tilt * kDegree);
    case Reason::kTooNear:
      return print("the camera is %.2f m above the largest plane that faces up, less than min_camera_height",
                   absence.height);
    case Reason::kTooFar:
      return print("the camera is %.2f m above the largest plane that faces up, more than max_camera_height",
                   absence.height);
    case Reason::kUnlikely:
      return print(
          "the largest plane that faces up, %.2f m below the camera, has too much below it or too few pixels "
          "on it",
          absence.height);
    case Reason::kNoPlane:
      break;
  }
  return print("no plane in view; %.0f %% of the samples have a return", 100.0 * absence.point_share);
}

}  // namespace polygonal_perception::ros_perception

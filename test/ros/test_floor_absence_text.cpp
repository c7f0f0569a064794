#include <gtest/gtest.h>

#include "ros/perception/floor_absence_text.hpp"

namespace polygonal_perception::ros_perception {
namespace {

using perception::FloorAbsence;

std::string textOf(FloorAbsence::Reason reason, bool from_mount = false)
{
  FloorAbsence absence;
  absence.up_is_from_tf = from_mount;
  absence.bounds_are_mounts = from_mount;
  absence.lowest = 0.05;
  absence.highest = 3.0;
  absence.reason = reason;
  absence.point_share = 0.04;
  absence.normal = Eigen::Vector3d(0.0, 0.6, -0.8);
  absence.tilt = 1.5;
  absence.height = 0.456;
  return absenceText(absence);
}

TEST(FloorAbsenceText, NamesWhatWasSeenAndTheParameterThatSaysOtherwise)
{
  using Reason = FloorAbsence::Reason;
  EXPECT_EQ(textOf(Reason::kNoPlane), "no plane in view; 4 % of the samples have a return");
  EXPECT_EQ(textOf(Reason::kNoneFacesUp),
            "no plane in view faces up: the largest faces (0.00, 0.60, -0.80), 86 degrees from the up "
            "vector; if that is the "
            "floor, set initial_up to it");
  for (const Reason reason : {Reason::kTooNear, Reason::kTooFar}) {
    EXPECT_EQ(
        textOf(reason),
        "the camera is 0.46 m above the largest plane that faces up, sought is a floor 0.05 to 3.00 m below "
        "it (min_camera_height, max_camera_height)");
  }
  EXPECT_EQ(textOf(Reason::kUnlikely),
            "the largest plane that faces up, 0.46 m below the camera, has too much below it or too few "
            "pixels on it");
}

TEST(FloorAbsenceText, BlamesTfWhereUpComesFromThere)
{
  using Reason = FloorAbsence::Reason;
  EXPECT_EQ(
      textOf(Reason::kNoneFacesUp, true),
      "no plane in view faces up as tf has it: the largest faces (0.00, 0.60, -0.80), 86 degrees from that; "
      "if that is the floor, the input's frame_id or tf is wrong");
  EXPECT_EQ(
      textOf(Reason::kNotLevelInTf, true),
      "the largest plane that faces up is 86 degrees from level as tf has it: the input's frame_id or tf is "
      "wrong");
  EXPECT_EQ(
      textOf(Reason::kTooNear, true),
      "the camera is 0.46 m above the largest plane that faces up, sought is a floor 0.05 to 3.00 m below it "
      "(mount_frame)");
}

}  // namespace
}  // namespace polygonal_perception::ros_perception

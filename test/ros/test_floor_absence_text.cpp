#include <gtest/gtest.h>

#include "ros/perception/floor_absence_text.hpp"

namespace polygonal_perception::ros_perception {
namespace {

using perception::FloorAbsence;

std::string textOf(FloorAbsence::Reason reason)
{
  FloorAbsence absence;
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
  EXPECT_EQ(textOf(Reason::kTooNear),
            "the camera is 0.46 m above the largest plane that faces up, less than min_camera_height");
  EXPECT_EQ(textOf(Reason::kTooFar),
            "the camera is 0.46 m above the largest plane that faces up, more than max_camera_height");
  EXPECT_EQ(textOf(Reason::kUnlikely),
            "the largest plane that faces up, 0.46 m below the camera, has too much below it or too few "
            "pixels on it");
}

}  // namespace
}  // namespace polygonal_perception::ros_perception

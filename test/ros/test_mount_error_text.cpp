#include <gtest/gtest.h>

#include "ros/perception/mount_error_text.hpp"
#include "support/plane_scene.hpp"

namespace polygonal_perception::ros_perception {
namespace {

TEST(MountErrorText, SaysHowTheCameraHasTilted)
{
  perception::FloorState floor;
  const auto text = [&](const geometry::Plane& seen) {
    floor.floor.plane = seen;
    floor.mount_error = perception::mountError(floor.floor, test::floorSeenFrom(0.8, 0.3), {});
    return mountErrorText(floor, Eigen::Vector3d::UnitZ(), -Eigen::Vector3d::UnitY(), "base_footprint");
  };
  constexpr double kDegree = 0.017453292519943295;
  EXPECT_EQ(text(test::floorSeenFrom(0.812, 0.3 + 3 * kDegree)),
            "the camera is tilted by 3.0 degrees against mount_frame 'base_footprint' (it looks 3.0 degrees "
            "further "
            "down and is rolled by 0.0) and 0.012 m higher");
  EXPECT_EQ(text(test::floorSeenFrom(0.79, 0.3 - 1 * kDegree)),
            "the camera is tilted by 1.0 degrees against mount_frame 'base_footprint' (it looks 1.0 degrees "
            "further "
            "up and is rolled by 0.0) and 0.010 m lower");
}

}  // namespace
}  // namespace polygonal_perception::ros_perception

#include <gtest/gtest.h>

#include "cameras/openni2_ros/openni2_camera_parameters.hpp"

namespace polygonal_perception::openni2_ros {
namespace {

TEST(OpenNI2CameraParameters, AreGoodAsTheyAre)
{
  const OpenNI2CameraParameters parameters;
  EXPECT_FALSE(parameters::findFault(parameters));
  EXPECT_EQ(parameters.options().width, 640);
  EXPECT_EQ(parameters.frameId(), "camera_depth_optical_frame");
}

TEST(OpenNI2CameraParameters, ADepthModeStandsForSizeAndRate)
{
  OpenNI2CameraParameters parameters;
  parameters.source.width = 1;
  parameters.source.mirror = true;
  parameters.depth_mode = 9;
  const openni2::SourceOptions options = parameters.options();
  EXPECT_EQ(options.width, 320);
  EXPECT_EQ(options.rate, 60);
  EXPECT_TRUE(options.mirror);
}

TEST(OpenNI2CameraParameters, ADepthModeThatThereIsNotIsRefused)
{
  OpenNI2CameraParameters parameters;
  parameters.depth_mode = 13;
  const auto fault = parameters::findFault(parameters);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->reason, "depth_mode is 13, accepted is 0 to 12");
}

TEST(OpenNI2CameraParameters, RegisteredDepthIsTheColourCameras)
{
  OpenNI2CameraParameters parameters;
  parameters.source.registration = true;
  parameters.depth_camera_info_url = "file:///depth.yaml";
  parameters.rgb_camera_info_url = "file:///rgb.yaml";
  EXPECT_STREQ(parameters.view(), "rgb");
  EXPECT_EQ(parameters.frameId(), "camera_rgb_optical_frame");
  EXPECT_EQ(parameters.cameraInfoUrl(), "file:///rgb.yaml");
}

}  // namespace
}  // namespace polygonal_perception::openni2_ros

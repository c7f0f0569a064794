#include <gtest/gtest.h>

#include <boost/make_shared.hpp>
#include <cmath>
#include <cstring>
#include <limits>

#include "ros/perception/depth_input.hpp"

namespace polygonal_perception::ros_perception {
namespace {

constexpr std::uint32_t kWidth = 4;
constexpr std::uint32_t kHeight = 2;

/// Depth k + 1 metres in pixel k, in rows that are padded; the last has no return.
template <class Depth>
sensor_msgs::Image image(const std::string& encoding, Depth scale, Depth none, double stamp = 1.0)
{
  sensor_msgs::Image image;
  image.header.stamp.fromSec(stamp);
  image.encoding = encoding;
  image.width = kWidth;
  image.height = kHeight;
  image.step = kWidth * sizeof(Depth) + 2;
  image.data.resize(image.height * image.step);
  for (std::uint32_t k = 0; k < kWidth * kHeight; ++k) {
    const Depth depth = k + 1 == kWidth * kHeight ? none : static_cast<Depth>((k + 1) * scale);
    std::memcpy(image.data.data() + k / kWidth * image.step + k % kWidth * sizeof depth, &depth,
                sizeof depth);
  }
  return image;
}

sensor_msgs::Image millimetres(double stamp = 1.0)
{
  return image<std::uint16_t>("16UC1", 1000, 0, stamp);
}
sensor_msgs::Image metres()
{
  return image<float>("32FC1", 1.0F, NAN);
}

sensor_msgs::CameraInfoPtr info(double stamp = 1.0)
{
  auto info = boost::make_shared<sensor_msgs::CameraInfo>();
  info->header.stamp.fromSec(stamp);
  info->width = kWidth;
  info->height = kHeight;
  info->K = {7.0, 0.0, 7.0, 0.0, 7.0, 7.0, 0.0, 0.0, 1.0};  // of the raw image: not to be used
  info->P = {2.0, 0.0, 1.0, 0.0, 0.0, 4.0, 0.5, 0.0, 0.0, 0.0, 1.0, 0.0};
  return info;
}

template <class Spoil>
std::string errorOf(Spoil&& spoil)
{
  DepthInput input("/camera/camera_info");
  sensor_msgs::Image bad = millimetres();
  sensor_msgs::CameraInfoPtr bad_info = info();
  spoil(bad, *bad_info);
  input.setCameraInfo(bad_info);
  const ros_common::Expected<perception::PointView> view = input.view(bad);
  EXPECT_FALSE(view);
  return view.error();
}

TEST(DepthInput, ReadsMillimetresAndMetresByTheRectifiedProjection)
{
  DepthInput input("/camera/camera_info");
  input.setCameraInfo(info());
  for (const sensor_msgs::Image& image : {millimetres(), metres()}) {
    const ros_common::Expected<perception::PointView> view = input.view(image);
    ASSERT_TRUE(view) << view.error();
    // z (u - cx) / fx, z (v - cy) / fy, z
    EXPECT_TRUE(view->point(0, 0).isApprox(Eigen::Vector3f(-0.5F, -0.125F, 1.0F)))
        << view->point(0, 0).transpose();
    EXPECT_TRUE(view->point(2, 1).isApprox(Eigen::Vector3f(3.5F, 0.875F, 7.0F)))
        << view->point(2, 1).transpose();
    EXPECT_TRUE(view->point(3, 1).array().isNaN().any());
    EXPECT_EQ(view->row(0), image.data.data()) << "nothing may be copied";
  }
}

TEST(DepthInput, ReadsOtherUnitsThanMillimetres)
{
  DepthInput input("/camera/camera_info");
  input.setCameraInfo(info());
  const sensor_msgs::Image image = millimetres();
  const double in_millimetres = input.view(image)->point(0, 0).z();
  EXPECT_NEAR(input.view(image, 0.00025)->point(0, 0).z(), 0.25 * in_millimetres, 1e-6);
  EXPECT_NEAR(input.view(metres(), 0.00025)->point(0, 0).z(), 1.0, 1e-6)
      << "a unit is of whole numbers alone";
}

TEST(DepthInput, ADistortionIsSaidOnceForEachCalibration)
{
  DepthInput input("/camera/camera_info");
  const sensor_msgs::Image image = millimetres();
  const auto noticeOf = [&](const std::vector<double>& coefficients, double stamp) {
    const sensor_msgs::CameraInfoPtr calibration = info(stamp);
    calibration->distortion_model = "plumb_bob";
    calibration->D = coefficients;
    input.setCameraInfo(calibration);
    EXPECT_TRUE(input.view(image));
    return input.takeNotice();
  };
  EXPECT_EQ(noticeOf({}, 1.0), "");
  EXPECT_EQ(noticeOf({0.0, 0.0, 0.0, 0.0, 0.0}, 2.0), "");
  EXPECT_EQ(noticeOf({-0.2, 0.05, 0.0, 0.0, 0.0}, 3.0),
            "/camera/camera_info has a lens distortion (plumb_bob, D begins -0.2, 0.05, 0, 0, 0): "
            "depth/image must be the "
            "rectified image (image_rect), or obstacles are in wrong places");
  EXPECT_EQ(noticeOf({-0.2, 0.05, 0.0, 0.0, 0.0}, 4.0), "") << "of the same calibration, in a new message";
  EXPECT_NE(noticeOf({-0.1, 0.05, 0.0, 0.0, 0.0}, 5.0), "") << "of another";
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(noticeOf({kNaN, 0.0, 0.0, 0.0, 0.0}, 6.0), "");
  EXPECT_EQ(noticeOf({kNaN, 0.0, 0.0, 0.0, 0.0}, 7.0), "") << "NaN is no news when it comes again";
}

TEST(DepthInput, BinningAndRegionOfInterestLeadToTheImage)
{
  DepthInput input("/camera/camera_info");
  sensor_msgs::CameraInfoPtr full = info();
  full->width = 20;
  full->height = 10;
  full->roi.x_offset = 4;
  full->roi.y_offset = 2;
  full->roi.width = 8;
  full->roi.height = 4;
  full->binning_x = full->binning_y = 2;
  full->P = {4.0, 0.0, 6.0, 0.0, 0.0, 8.0, 3.0, 0.0, 0.0, 0.0, 1.0, 0.0};
  input.setCameraInfo(full);
  const sensor_msgs::Image message = millimetres();
  const ros_common::Expected<perception::PointView> view = input.view(message);
  ASSERT_TRUE(view) << view.error();
  EXPECT_TRUE(view->point(2, 1).isApprox(Eigen::Vector3f(3.5F, 0.875F, 7.0F)))
      << view->point(2, 1).transpose();
}

TEST(DepthInput, FollowsANewCalibrationAndSize)
{
  DepthInput input("/camera/camera_info");
  input.setCameraInfo(info());
  const sensor_msgs::Image message = millimetres();
  EXPECT_NEAR(input.view(message)->point(0, 0).x(), -0.5, 1e-6);
  sensor_msgs::CameraInfoPtr changed = info();
  changed->P[0] = 1.0;
  input.setCameraInfo(changed);
  EXPECT_NEAR(input.view(message)->point(0, 0).x(), -1.0, 1e-6);
}

TEST(DepthInput, WaitsForTheInfoOfAnImageWhereTheyComeInPairs)
{
  DepthInput input("/camera/camera_info");
  EXPECT_TRUE(input.awaitsCameraInfo(millimetres(1.0))) << "none yet";
  EXPECT_EQ(input.view(millimetres(1.0)).error(), "no camera_info has come yet on /camera/camera_info");
  input.setCameraInfo(info(1.0));
  EXPECT_FALSE(input.awaitsCameraInfo(millimetres(1.0)));
  input.view(millimetres(1.0));
  EXPECT_TRUE(input.awaitsCameraInfo(millimetres(2.0))) << "the last pair had one stamp";
  // It did not come in time: do not wait for the next.
  input.view(millimetres(2.0));
  EXPECT_FALSE(input.awaitsCameraInfo(millimetres(3.0)));
  // It comes late, but it comes.
  input.setCameraInfo(info(2.0));
  EXPECT_TRUE(input.awaitsCameraInfo(millimetres(3.0)));
}

TEST(DepthInput, DoesNotWaitForAnInfoThatCameOnce)
{
  DepthInput input("/camera/camera_info");
  input.setCameraInfo(info(0.0));
  EXPECT_FALSE(input.awaitsCameraInfo(millimetres(1.0)));
  EXPECT_TRUE(input.view(millimetres(1.0)));
  EXPECT_FALSE(input.awaitsCameraInfo(millimetres(2.0)));
}

TEST(DepthInput, AnImageThatIsRefusedDoesNotEndTheWaitForPairs)
{
  DepthInput input("/camera/camera_info");
  input.setCameraInfo(info(1.0));
  ASSERT_TRUE(input.view(millimetres(1.0)));
  sensor_msgs::Image bad = millimetres(0.0);
  bad.encoding = "bgr8";
  EXPECT_FALSE(input.view(bad));
  EXPECT_TRUE(input.awaitsCameraInfo(millimetres(2.0))) << "the last good image had its pair";
}

TEST(DepthInput, SaysWhatIsWrongWithTheImage)
{
  using Image = sensor_msgs::Image;
  using Info = sensor_msgs::CameraInfo;
  EXPECT_EQ(errorOf([](Image& i, Info&) { i.encoding = "bgr8"; }),
            "encoding is 'bgr8', accepted are 16UC1 (in depth_unit) and 32FC1 (m)");
  EXPECT_EQ(errorOf([](Image& i, Info&) { i.width = 0; }), "width is 0, accepted is 2 to 65535");
  EXPECT_EQ(errorOf([](Image& i, Info&) { i.is_bigendian = 1; }), "is_bigendian is true, accepted is false");
  EXPECT_EQ(errorOf([](Image& i, Info&) { i.step = 7; }), "step is 7, accepted is at least 8");
  EXPECT_EQ(errorOf([](Image& i, Info&) { i.data.pop_back(); }),
            "data has 19 bytes, accepted is height x step = 20");
}

TEST(DepthInput, SaysWhatIsWrongWithTheCalibration)
{
  using Image = sensor_msgs::Image;
  using Info = sensor_msgs::CameraInfo;
  const std::string accepted =
      "; accepted are finite ones, fx and fy positive, all pixels within 89 deg of the axis (is the camera "
      "calibrated?)";
  EXPECT_EQ(errorOf([](Image&, Info& info) { info.width = 8; }),
            "camera_info is for an image of 8x2, the image has 4x2");
  EXPECT_EQ(errorOf([](Image&, Info& info) {
              info.P.fill(0.0);
              info.K.fill(0.0);
            }),
            "camera_info has fx, fy, cx, cy of 0, 0, 0, 0" + accepted);
  EXPECT_EQ(errorOf([](Image&, Info& info) { info.P[2] = NAN; }),
            "camera_info has fx, fy, cx, cy of 2, 4, nan, 0.5" + accepted);
  // In metres; of a region of interest that is none; so small that the rays leave the range of floats.
  EXPECT_EQ(errorOf([](Image&, Info& info) { info.P[0] = 0.005; }),
            "camera_info has fx, fy, cx, cy of 0.005, 4, 1, 0.5" + accepted);
  EXPECT_EQ(errorOf([](Image&, Info& info) { info.roi.y_offset = 1000; }),
            "camera_info has fx, fy, cx, cy of 2, 4, 1, -999.5" + accepted);
  EXPECT_EQ(errorOf([](Image&, Info& info) { info.P[5] = 1e-300; }),
            "camera_info has fx, fy, cx, cy of 2, 1e-300, 1, 0.5" + accepted);
}

}  // namespace
}  // namespace polygonal_perception::ros_perception

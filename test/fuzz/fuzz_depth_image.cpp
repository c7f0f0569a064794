// An Image and its CameraInfo: refused with a reason, or looked at within their data.
#include <boost/make_shared.hpp>

#include "byte_reader.hpp"
#include "result_check.hpp"
#include "ros/perception/depth_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace polygonal_perception;
  using namespace polygonal_perception::test;
  ByteReader bytes(data, size);
  sensor_msgs::Image image;
  image.width = bytes.size();
  image.height = bytes.size();
  image.step = bytes.size();
  image.is_bigendian = bytes.byte() == 1 ? 1 : 0;
  const std::uint8_t encoding = bytes.byte() % 4;
  image.encoding = encoding == 3   ? bytes.text()
                   : encoding == 2 ? "mono16"
                   : encoding == 1 ? "16UC1"
                                   : "32FC1";

  auto info = boost::make_shared<sensor_msgs::CameraInfo>();
  const bool same_size = bytes.byte() != 1;
  info->width = same_size ? image.width : bytes.size();
  info->height = same_size ? image.height : bytes.size();
  info->header.stamp = ros::Time(bytes.byte() == 1 ? 1 : 0, 0);
  const bool has_projection = bytes.byte() != 1;
  const double intrinsics[] = {bytes.number<double>(), bytes.number<double>(), bytes.number<double>(),
                               bytes.number<double>()};
  // Of the order of an image's size.
  constexpr double kPixels = 20.0;
  const double fx = kPixels * intrinsics[0];
  const double fy = kPixels * intrinsics[1];
  if (has_projection) {
    info->P = {fx, 0.0, intrinsics[2], 0.0, 0.0, fy, intrinsics[3], 0.0, 0.0, 0.0, 1.0, 0.0};
  } else {
    info->K = {fx, 0.0, intrinsics[2], 0.0, fy, intrinsics[3], 0.0, 0.0, 1.0};
  }
  if (bytes.byte() == 1) {
    info->binning_x = bytes.size();
    info->binning_y = bytes.size();
    info->roi.x_offset = bytes.size();
    info->roi.y_offset = bytes.size();
    info->roi.width = bytes.size();
    info->roi.height = bytes.size();
  }
  const bool has_info = bytes.byte() != 1;
  image.data = bytes.rest();
  image.data.shrink_to_fit();

  ros_perception::DepthInput input("camera_info");
  if (has_info) input.setCameraInfo(info);
  input.awaitsCameraInfo(image);
  const ros_common::Expected<perception::PointView> view = input.view(image);
  require(view || !view.error().empty(), "what is refused has a reason");
  require(view ? has_info : true, "without a camera_info there are no points");
  if (!view) return 0;
  perception::Pipeline pipeline{perception::Pipeline::Parameters{}};
  requireSound(pipeline.process({*view, 1.0, {}}, kAllProducts));
  return 0;
}

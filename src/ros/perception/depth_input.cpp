#include "ros/perception/depth_input.hpp"

#include <sensor_msgs/image_encodings.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "polygonal_perception/parameters/parameter_check.hpp"
#include "ros/perception/image_size.hpp"

namespace polygonal_perception::ros_perception {

namespace {

/// A pinhole's intrinsics at the size of the image [px].
struct Intrinsics
{
  double fx = 0.0;
  double fy = 0.0;
  double cx = 0.0;
  double cy = 0.0;
};

/// The projection of the rectified image, in P; drivers that leave P empty mean K. Both are given for the
/// full sensor: binning and region of interest lead to the image.
Intrinsics intrinsicsOf(const sensor_msgs::CameraInfo& info)
{
  const bool has_projection = info.P[0] != 0.0;
  const double binning_x = std::max(info.binning_x, 1U);
  const double binning_y = std::max(info.binning_y, 1U);
  return {(has_projection ? info.P[0] : info.K[0]) / binning_x,
          (has_projection ? info.P[5] : info.K[4]) / binning_y,
          ((has_projection ? info.P[2] : info.K[2]) - info.roi.x_offset) / binning_x,
          ((has_projection ? info.P[6] : info.K[5]) - info.roi.y_offset) / binning_y};
}

/// Whether every pixel lies within 89 degrees of the optical axis: others come from numbers that are no
/// pixels (metres, say) or of another image. Written so that NaN fails.
bool seesAhead(const Intrinsics& k, const sensor_msgs::Image& image)
{
  constexpr double kSteepest = 57.0;  // tan(89 degrees)
  const double across = std::max(std::abs(k.cx), std::abs(image.width - 1.0 - k.cx));
  const double down = std::max(std::abs(k.cy), std::abs(image.height - 1.0 - k.cy));
  return across < kSteepest * k.fx && down < kSteepest * k.fy;
}

std::uint32_t imageSide(std::uint32_t full, std::uint32_t region, std::uint32_t binning)
{
  return (region != 0 ? region : full) / std::max(binning, 1U);
}

std::string sizeText(std::uint32_t width, std::uint32_t height)
{
  return std::to_string(width) + "x" + std::to_string(height);
}

/// Bit by bit: a driver's NaN is the same as its last one.
template <class Numbers>
bool areSame(const Numbers& a, const Numbers& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

/// An image that was rectified has the same camera_info as the one that it was made of: nobody can tell from it which of
/// them has come.
std::string distortionNotice(const sensor_msgs::CameraInfo& info, const std::string& topic)
{
  if (std::all_of(info.D.begin(), info.D.end(), [](double coefficient) { return coefficient == 0.0; }))
    return {};
  std::string coefficients;
  for (std::size_t k = 0; k < std::min(info.D.size(), std::size_t{5}); ++k)
    coefficients += (k > 0 ? ", " : "") + parameters::numberText(info.D[k]);
  return topic + " has a lens distortion (" + info.distortion_model + ", D begins " + coefficients +
         "): depth/image must be the rectified image (image_rect), or obstacles are in wrong places";
}

}  // namespace

void DepthInput::setCameraInfo(const sensor_msgs::CameraInfoConstPtr& info)
{
  info_ = info;
  if (info->header.stamp == last_image_) in_pairs_ = true;
}

bool DepthInput::awaitsCameraInfo(const sensor_msgs::Image& image) const
{
  return !info_ || (in_pairs_ && info_->header.stamp != image.header.stamp);
}

ros_common::Expected<perception::PointView> DepthInput::view(const sensor_msgs::Image& image, double unit)
{
  namespace encodings = sensor_msgs::image_encodings;
  using Result = ros_common::Expected<perception::PointView>;
  if (const std::string error = imageSizeError(image.width, image.height); !error.empty()) {
    return Result::failure(error);
  }
  // "mono16" is what 16UC1 becomes on the way through some image tools.
  const bool whole_numbers = image.encoding == encodings::TYPE_16UC1 || image.encoding == encodings::MONO16;
  if (!whole_numbers && image.encoding != encodings::TYPE_32FC1) {
    return Result::failure("encoding is '" + image.encoding +
                           "', accepted are 16UC1 (in depth_unit) and 32FC1 (m)");
  }
  if (image.is_bigendian != 0) return Result::failure("is_bigendian is true, accepted is false");
  const std::uint64_t row =
      std::uint64_t{image.width} * (whole_numbers ? sizeof(std::uint16_t) : sizeof(float));
  if (image.step < row) {
    return Result::failure("step is " + std::to_string(image.step) + ", accepted is at least " +
                           std::to_string(row));
  }
  const std::uint64_t size = std::uint64_t{image.height} * image.step;
  if (image.data.size() < size) {
    return Result::failure("data has " + std::to_string(image.data.size()) +
                           " bytes, accepted is height x step = " + std::to_string(size));
  }
  if (const std::string error = adoptCalibration(image); !error.empty()) return Result::failure(error);
  last_image_ = image.header.stamp;
  in_pairs_ = info_->header.stamp == last_image_;

  const void* const data = image.data.data();
  return whole_numbers
             ? perception::PointView::depth(static_cast<const std::uint16_t*>(data), image.step, rays_, unit)
             : perception::PointView::depth(static_cast<const float*>(data), image.step, rays_);
}

std::string DepthInput::adoptCalibration(const sensor_msgs::Image& image)
{
  if (!info_) return "no camera_info has come yet on " + info_topic_;
  const sensor_msgs::CameraInfo& info = *info_;
  const std::uint32_t width = imageSide(info.width, info.roi.width, info.binning_x);
  const std::uint32_t height = imageSide(info.height, info.roi.height, info.binning_y);
  // Some publishers leave the size out.
  const bool has_size = info.width != 0 && info.height != 0;
  if (has_size && (width != image.width || height != image.height)) {
    return "camera_info is for an image of " + sizeText(width, height) + ", the image has " +
           sizeText(image.width, image.height);
  }
  const Intrinsics k = intrinsicsOf(info);
  if (!(k.fx > 0.0 && k.fy > 0.0 && std::isfinite(k.fx + k.fy + k.cx + k.cy) && seesAhead(k, image))) {
    return "camera_info has fx, fy, cx, cy of " + parameters::numberText(k.fx) + ", " +
           parameters::numberText(k.fy) + ", " + parameters::numberText(k.cx) + ", " +
           parameters::numberText(k.cy) +
           "; accepted are finite ones, fx and fy positive, all pixels within 89 deg of the axis (is the "
           "camera calibrated?)";
  }
  const bool same_size = rays_.column_slope.size() == image.width && rays_.row_slope.size() == image.height;
  const bool same_calibration =
      info_of_rays_ == info_ ||
      (info_of_rays_ && areSame(info_of_rays_->P, info.P) && areSame(info_of_rays_->K, info.K) &&
       areSame(info_of_rays_->D, info.D) && info_of_rays_->roi == info.roi &&
       info_of_rays_->binning_x == info.binning_x && info_of_rays_->binning_y == info.binning_y);
  if (!same_size || !same_calibration) {
    rays_ = perception::PinholeRays::make(image.width, image.height, k.fx, k.fy, k.cx, k.cy);
    notice_ = distortionNotice(info, info_topic_);
    info_of_rays_ = info_;
  }
  return {};
}

}  // namespace polygonal_perception::ros_perception

#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "polygonal_perception/perception/input/ignored_boxes.hpp"
#include "polygonal_perception/perception/input/range_limits.hpp"

namespace polygonal_perception::perception {

/// The viewing rays of a pinhole camera without distortion, one entry a column and one a row, so that a depth
/// image turns into points with two multiplications: p = z (column_slope[u], row_slope[v], 1).
///
/// Made anew only when the camera's calibration or the image's size changes.
struct PinholeRays
{
  std::vector<float> column_slope;  ///< (u - cx) / fx
  std::vector<float> row_slope;     ///< (v - cy) / fy

  /// @param fx,fy,cx,cy  intrinsics [px]; fx and fy must be positive and finite
  static PinholeRays make(std::uint32_t width, std::uint32_t height, double fx, double fy, double cx,
                          double cy)
  {
    PinholeRays rays;
    rays.column_slope.resize(width);
    rays.row_slope.resize(height);
    for (std::uint32_t u = 0; u < width; ++u) rays.column_slope[u] = static_cast<float>((u - cx) / fx);
    for (std::uint32_t v = 0; v < height; ++v) rays.row_slope[v] = static_cast<float>((v - cy) / fy);
    return rays;
  }

  /// The matrix that takes a direction to (u, v, 1) up to a positive factor.
  Eigen::Matrix3f pixelOfDirection() const
  {
    const auto line = [](const std::vector<float>& slopes) {
      const float per_pixel =
          slopes.size() > 1 ? (slopes.back() - slopes.front()) / static_cast<float>(slopes.size() - 1) : 1.0F;
      return Eigen::Vector2f(1.0F / per_pixel, -slopes.front() / per_pixel);
    };
    const Eigen::Vector2f u = line(column_slope);
    const Eigen::Vector2f v = line(row_slope);
    Eigen::Matrix3f matrix;
    matrix << u.x(), 0.0F, u.y(), 0.0F, v.x(), v.y(), 0.0F, 0.0F, 1.0F;
    return matrix;
  }
};

/// How the points of an organised frame lie in memory.
enum class PointLayout : std::uint8_t
{
  kCloud,       ///< float32 x, y, z at fixed offsets in each point
  kDepthUnits,  ///< uint16 depth along the optical axis in a unit, most often 1 mm; 0 and 65535 = no return
  kDepthMetres  ///< float32 depth along the optical axis [m]; NaN, inf and <= 0 = no return
};

/// A view onto an organised frame of points. It copies and owns nothing: the memory (and the rays) must
/// outlive it.
///
/// Nothing else in the package knows how points lie in memory. Points are given in the input's frame in
/// metres; a pixel without a return has at least one NaN coordinate. A cloud's point in the sensor itself, as (0, 0, 0),
/// which many drivers write, is no return either, nor is one beyond the limits of within() or in the boxes of without(). A depth image's points are in an optical
/// frame (x right, y down, z forward); a cloud's are in whatever frame its publisher chose.
class PointView
{
public:
  /// Byte offsets and strides of a point cloud; a depth image has only steps.
  struct CloudStrides
  {
    std::size_t row_step = 0;
    std::size_t point_step = 0;
    std::size_t x_offset = 0;
    std::size_t y_offset = 4;
    std::size_t z_offset = 8;
  };

  PointView() = default;

  /// A view onto a PointCloud2's data: any offsets and steps, little-endian float32. No alignment is assumed.
  static PointView cloud(const void* data, std::uint32_t width, std::uint32_t height,
                         const CloudStrides& strides)
  {
    PointView view(data, width, height, PointLayout::kCloud);
    view.strides_ = strides;
    return view;
  }

  /// A view onto an organised array of points with public members x, y, z, such as
  /// pcl::PointCloud<T>::points.
  template <class Point>
  static PointView points(const Point* data, std::uint32_t width, std::uint32_t height)
  {
    CloudStrides strides;
    strides.point_step = sizeof(Point);
    strides.row_step = sizeof(Point) * width;
    const Point* const first = data;
    strides.x_offset = byteOffset(first, &first->x);
    strides.y_offset = byteOffset(first, &first->y);
    strides.z_offset = byteOffset(first, &first->z);
    return cloud(data, width, height, strides);
  }

  /// A view onto a depth image of whole numbers (16UC1).
  /// @param unit  [m] of the numbers
  static PointView depth(const std::uint16_t* data, std::size_t row_step, const PinholeRays& rays,
                         double unit = 0.001)
  {
    PointView view = depthImage(data, row_step, rays, PointLayout::kDepthUnits);
    view.unit_ = static_cast<float>(unit);
    return view;
  }

  /// A view onto a depth image in metres (32FC1).
  static PointView depth(const float* data, std::size_t row_step, const PinholeRays& rays)
  {
    return depthImage(data, row_step, rays, PointLayout::kDepthMetres);
  }

  /// The same view, without the points that are nearer to the sensor or farther from it.
  PointView within(const RangeLimits& limits) const
  {
    PointView view = *this;
    const auto squared = [](double range) { return static_cast<float>(range * range); };
    view.nearest_squared_ = std::max(kLeastSquared, squared(limits.min_range));
    view.farthest_squared_ = limits.max_range > 0.0 ? squared(limits.max_range) : kMostSquared;
    return view;
  }

  /// The same view, without the points in some boxes, which must outlive it.
  PointView without(const IgnoredBoxes& boxes) const
  {
    PointView view = *this;
    view.ignored_ = boxes.empty() ? nullptr : &boxes;
    return view;
  }

  std::uint32_t width() const { return width_; }
  std::uint32_t height() const { return height_; }
  std::size_t size() const { return static_cast<std::size_t>(width_) * height_; }
  PointLayout layout() const { return layout_; }
  const CloudStrides& strides() const { return strides_; }
  /// The rays of a depth image; nullptr for a cloud.
  const PinholeRays* rays() const { return rays_; }
  /// [m] What a number in a depth image means.
  float unit() const { return unit_; }
  /// [m^2] Squares of the ranges between which points lie.
  float nearestSquared() const { return nearest_squared_; }
  float farthestSquared() const { return farthest_squared_; }
  /// Whether points are left out by their range, but for the default: what lies in the sensor itself.
  bool isLimited() const
  {
    constexpr double kDefault = RangeLimits{}.min_range;
    return nearest_squared_ > static_cast<float>(kDefault * kDefault) || farthest_squared_ < kMostSquared;
  }
  /// Whether points are left out by where they lie.
  bool leavesOut() const { return ignored_ != nullptr; }
  /// The first byte of row v.
  const std::uint8_t* row(std::uint32_t v) const { return data_ + v * strides_.row_step; }

  /// The point of pixel (u, v) [m], with a NaN coordinate where there is no return.
  Eigen::Vector3f point(std::uint32_t u, std::uint32_t v) const
  {
    Eigen::Vector3f point = layout_ == PointLayout::kCloud ? cloudPoint(u, v) : depthPoint(u, v);
    const float squared = point.squaredNorm();
    // Written so that NaN fails.
    if (squared >= nearest_squared_ && squared <= farthest_squared_ &&
        !(leavesOut() && ignored_->contain(point)))
      return point;
    return Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
  }

  /// Asks for the memory of pixel (u, v): for those who are about to read many that lie far apart.
  void prefetch(std::uint32_t u, std::uint32_t v) const
  {
    __builtin_prefetch(row(v) + u * strides_.point_step);
  }

private:
  PointView(const void* data, std::uint32_t width, std::uint32_t height, PointLayout layout)
      : data_(static_cast<const std::uint8_t*>(data)), width_(width), height_(height), layout_(layout)
  {
  }

  Eigen::Vector3f cloudPoint(std::uint32_t u, std::uint32_t v) const
  {
    const std::uint8_t* at = row(v) + u * strides_.point_step;
    return {load<float>(at + strides_.x_offset), load<float>(at + strides_.y_offset),
            load<float>(at + strides_.z_offset)};
  }

  /// Without a return it is a point in the camera, or NaN.
  Eigen::Vector3f depthPoint(std::uint32_t u, std::uint32_t v) const
  {
    float z = 0.0F;
    if (layout_ == PointLayout::kDepthUnits) {
      const auto units = load<std::uint16_t>(row(v) + u * sizeof(std::uint16_t));
      z = units == std::numeric_limits<std::uint16_t>::max() ? 0.0F : unit_ * static_cast<float>(units);
    } else {
      z = std::max(0.0F, load<float>(row(v) + u * sizeof(float)));
    }
    return {z * rays_->column_slope[u], z * rays_->row_slope[v], z};
  }

  static PointView depthImage(const void* data, std::size_t row_step, const PinholeRays& rays,
                              PointLayout layout)
  {
    PointView view(data, static_cast<std::uint32_t>(rays.column_slope.size()),
                   static_cast<std::uint32_t>(rays.row_slope.size()), layout);
    view.strides_.row_step = row_step;
    view.strides_.point_step = layout == PointLayout::kDepthUnits ? sizeof(std::uint16_t) : sizeof(float);
    view.rays_ = &rays;
    return view;
  }

  static std::size_t byteOffset(const void* from, const void* to)
  {
    return static_cast<std::size_t>(static_cast<const std::uint8_t*>(to) -
                                    static_cast<const std::uint8_t*>(from));
  }

  template <class T>
  static T load(const std::uint8_t* from)
  {
    T value;
    std::memcpy(&value, from, sizeof value);
    return value;
  }

  // [m^2] Of a point in the sensor, or so far away that its square is no number, nobody knows the range.
  static constexpr float kLeastSquared = std::numeric_limits<float>::min();
  static constexpr float kMostSquared = std::numeric_limits<float>::max();

  const std::uint8_t* data_ = nullptr;
  std::uint32_t width_ = 0;
  std::uint32_t height_ = 0;
  PointLayout layout_ = PointLayout::kCloud;
  CloudStrides strides_;
  const PinholeRays* rays_ = nullptr;
  float unit_ = 1.0F;
  float nearest_squared_ = kLeastSquared;
  float farthest_squared_ = kMostSquared;
  const IgnoredBoxes* ignored_ = nullptr;  // none where there are no boxes
};

}  // namespace polygonal_perception::perception

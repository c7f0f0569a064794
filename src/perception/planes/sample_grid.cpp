#include "polygonal_perception/perception/planes/sample_grid.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace polygonal_perception::perception {

namespace {

/// The pixel of sample i of n that are spread over a side of the image, its first and last pixel included.
int pixelOf(int i, int n, int side)
{
  // Rounded to the nearest, in integers: this is done for every sample of every frame.
  return n > 1 ? (2 * i * (side - 1) + (n - 1)) / (2 * (n - 1)) : side / 2;
}

bool isReturn(const Eigen::Vector3f& p)
{
  // A sum is NaN or infinite when one of its terms is; points far beyond any depth camera are garbage.
  constexpr float kFarthest = 1e3F;
  return std::abs(p.x()) + std::abs(p.y()) + std::abs(p.z()) < kFarthest;
}

/// The change of the surface along one direction of the grid: the central difference, unless a depth edge
/// lies on one side (the steps differ too much) or a neighbour is missing; then the one-sided difference to
/// the nearer neighbour.
bool difference(const Sample* before, const Sample& here, const Sample* after, Eigen::Vector3f& step)
{
  constexpr float kEdge = 2.5F * 2.5F;  // squared ratio of the steps' lengths
  const bool has_before = before != nullptr && before->has_point;
  const bool has_after = after != nullptr && after->has_point;
  if (!has_before && !has_after) return false;
  if (has_before && has_after) {
    const float to_before = (here.point - before->point).squaredNorm();
    const float to_after = (after->point - here.point).squaredNorm();
    if (to_before > kEdge * to_after) {
      step = after->point - here.point;
    } else if (to_after > kEdge * to_before) {
      step = here.point - before->point;
    } else {
      step = after->point - before->point;
    }
  } else {
    step =
        has_after ? Eigen::Vector3f(after->point - here.point) : Eigen::Vector3f(here.point - before->point);
  }
  return true;
}

}  // namespace

void SampleGrid::update(const PointView& points)
{
  samples_x_ = std::min(parameters_.samples_x, static_cast<int>(points.width()));
  samples_y_ = std::min(parameters_.samples_y, static_cast<int>(points.height()));
  samples_.resize(static_cast<std::size_t>(samples_x_) * static_cast<std::size_t>(samples_y_));
  takePoints(points);
  computeNormals();
}

void SampleGrid::takePoints(const PointView& points)
{
  constexpr std::array<std::pair<int, int>, 4> kDirections = {{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
  const auto width = static_cast<int>(points.width());
  const auto height = static_cast<int>(points.height());
  const int reach = std::max(width / samples_x_, height / samples_y_) / 4;
  const auto at = [](int pixel) { return static_cast<std::uint32_t>(pixel); };
  columns_.resize(static_cast<std::size_t>(samples_x_));
  for (int i = 0; i < samples_x_; ++i) columns_[static_cast<std::size_t>(i)] = pixelOf(i, samples_x_, width);
  for (int j = 0; j < samples_y_; ++j) {
    const int v = pixelOf(j, samples_y_, height);
    for (const int u : columns_) points.prefetch(at(u), at(v));
  }
  for (int j = 0; j < samples_y_; ++j) {
    const int v = pixelOf(j, samples_y_, height);
    for (int i = 0; i < samples_x_; ++i) {
      Sample& sample = samples_[static_cast<std::size_t>(j) * static_cast<std::size_t>(samples_x_) +
                                static_cast<std::size_t>(i)];
      const int u = columns_[static_cast<std::size_t>(i)];
      const auto take = [&](int at_u, int at_v) {
        if (at_u < 0 || at_u >= width || at_v < 0 || at_v >= height) return false;
        sample.point = points.point(at(at_u), at(at_v));
        sample.u = static_cast<std::uint16_t>(at_u);
        sample.v = static_cast<std::uint16_t>(at_v);
        return isReturn(sample.point);
      };
      sample.has_point = take(u, v);
      for (int distance = 1; distance <= reach && !sample.has_point; ++distance) {
        for (const auto& [du, dv] : kDirections) {
          sample.has_point = take(u + distance * du, v + distance * dv);
          if (sample.has_point) break;
        }
      }
      if (!sample.has_point) {
        sample.u = static_cast<std::uint16_t>(u);
        sample.v = static_cast<std::uint16_t>(v);
      }
    }
  }
}

void SampleGrid::computeNormals()
{
  const auto stride = static_cast<std::size_t>(samples_x_);
  for (int j = 0; j < samples_y_; ++j) {
    for (int i = 0; i < samples_x_; ++i) {
      Sample* const sample = &samples_[static_cast<std::size_t>(j) * stride + static_cast<std::size_t>(i)];
      sample->has_normal = false;
      if (!sample->has_point) continue;
      Eigen::Vector3f across;
      Eigen::Vector3f down;
      if (!difference(i > 0 ? sample - 1 : nullptr, *sample, i + 1 < samples_x_ ? sample + 1 : nullptr,
                      across))
        continue;
      if (!difference(j > 0 ? sample - stride : nullptr, *sample,
                      j + 1 < samples_y_ ? sample + stride : nullptr, down)) {
        continue;
      }
      // Right x down points away from the camera, whatever the axes of the input's frame; hence the sign of
      // eq. 2.
      const Eigen::Vector3f normal = down.cross(across);
      const float length = normal.norm();
      if (!(length > 0.0F)) continue;
      sample->normal = normal / length;
      sample->has_normal = true;
    }
  }
}

}  // namespace polygonal_perception::perception

#include "perception/floor/noisy_pixels.hpp"

#include <cmath>

namespace polygonal_perception::perception {

namespace {

// Most of the floor's time goes by in these loops. Compilers turn them into vector code, because a function's
// parameters can tell them that the arrays do not overlap.

/// What is known of points before there is a plane.
void measureRanges(std::size_t count, const SensorNoise& noise, const float* __restrict x,
                   const float* __restrict y, const float* __restrict z, float* __restrict range,
                   float* __restrict relative_noise)
{
  constexpr float kNoLess = 1e-3F;  // [m] keeps a point in the camera's centre from a division by zero
  const SensorNoise model = noise;
  for (std::size_t k = 0; k < count; ++k) {
    const float length = std::sqrt(x[k] * x[k] + y[k] * y[k] + z[k] * z[k]);
    const float at_least = length > kNoLess ? length : kNoLess;
    range[k] = at_least;
    relative_noise[k] = model.at(at_least) / at_least;
  }
}

/// What each point gives when it is held against a plane.
/// @return how many are in the band
std::int32_t residualsOf(const Eigen::Vector3f& normal, float distance, const NoisyPixels::Band& band,
                         std::size_t count, const float* __restrict x, const float* __restrict y,
                         const float* __restrict z, const float* __restrict range,
                         const float* __restrict relative_noise, float* __restrict sigmas,
                         float* __restrict heights, std::int32_t* __restrict on)
{
  const float nx = normal.x();
  const float ny = normal.y();
  const float nz = normal.z();
  const auto [band_sigmas, widest, model_error, model_error_slope] = band;
  std::int32_t inliers = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const float along = nx * x[k] + ny * y[k] + nz * z[k];
    const float sigma = relative_noise[k] * std::abs(along) + model_error + model_error_slope * range[k];
    const float wide = band_sigmas * sigma;
    const float half_width = wide < widest ? wide : widest;
    const float height = along + distance;
    sigmas[k] = sigma;
    heights[k] = height;
    const std::int32_t in_band = std::abs(height) < half_width ? 1 : 0;
    on[k] = in_band;
    inliers += in_band;
  }
  return inliers;
}

/// Takes points out of the band that lie nearer to another plane.
/// @return how many stay
std::int32_t keepNearer(const Eigen::Vector3f& normal, float distance, std::size_t count,
                        const float* __restrict x, const float* __restrict y, const float* __restrict z,
                        const float* __restrict heights, std::int32_t* __restrict on)
{
  const float nx = normal.x();
  const float ny = normal.y();
  const float nz = normal.z();
  std::int32_t inliers = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const float other = nx * x[k] + ny * y[k] + nz * z[k] + distance;
    on[k] &= std::abs(heights[k]) <= std::abs(other) ? 1 : 0;
    inliers += on[k];
  }
  return inliers;
}

}  // namespace

void NoisyPixels::resize(std::size_t count, std::size_t columns)
{
  columns_ = columns;
  for (auto* values : {&x_, &y_, &z_, &range_, &relative_noise_, &height_, &sigma_}) values->resize(count);
  on_.resize(count);
}

void NoisyPixels::measure(const SensorNoise& noise)
{
  measureRanges(size(), noise, x_.data(), y_.data(), z_.data(), range_.data(), relative_noise_.data());
}

void NoisyPixels::computeResiduals(const geometry::Plane& plane, const Band& band)
{
  camera_height_ = static_cast<float>(plane.distance);
  inliers_ = static_cast<std::size_t>(
      residualsOf(plane.normal.cast<float>(), camera_height_, band, size(), x_.data(), y_.data(), z_.data(),
                  range_.data(), relative_noise_.data(), sigma_.data(), height_.data(), on_.data()));
}

void NoisyPixels::computeResidualsOf(const std::vector<std::uint32_t>& points, const geometry::Plane& plane,
                                     const Band& band)
{
  const Eigen::Vector3f normal = plane.normal.cast<float>();
  const auto distance = static_cast<float>(plane.distance);
  for (const std::uint32_t k : points) {
    const float along = normal.x() * x_[k] + normal.y() * y_[k] + normal.z() * z_[k];
    sigma_[k] = relative_noise_[k] * std::abs(along) + band.model_error + band.model_error_slope * range_[k];
    height_[k] = along + distance;
  }
}

void NoisyPixels::giveTo(const geometry::Plane& other)
{
  inliers_ = static_cast<std::size_t>(keepNearer(other.normal.cast<float>(),
                                                 static_cast<float>(other.distance), size(), x_.data(),
                                                 y_.data(), z_.data(), height_.data(), on_.data()));
}

bool NoisyPixels::runsAlong(std::size_t k, std::size_t neighbour, float steepest, float sigmas) const
{
  const float dx = x_[neighbour] - x_[k];
  const float dy = y_[neighbour] - y_[k];
  const float dz = z_[neighbour] - z_[k];
  const float rise = std::abs(height_[neighbour] - height_[k]) - sigmas * relative_noise_[k] * camera_height_;
  // Written so that NaN is no step at all.
  return !(rise > 0.0F && rise * rise > steepest * steepest * (dx * dx + dy * dy + dz * dz));
}

}  // namespace polygonal_perception::perception

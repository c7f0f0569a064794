#include "perception/floor/noisy_points.hpp"

#include <algorithm>
#include <cmath>

#include "perception/floor/depth_noise.hpp"

namespace polygonal_perception::perception {

namespace {

// Most of the floor's time goes by in these two loops. Compilers turn them into vector code, because a
// function's parameters can tell them that the arrays do not overlap.

/// What is known of points before there is a plane.
void measureRanges(std::size_t count, const float* __restrict x, const float* __restrict y,
                   const float* __restrict z, float* __restrict range, float* __restrict relative_noise)
{
  constexpr float kNoLess = 1e-3F;  // [m] keeps a point in the camera's centre from a division by zero
  for (std::size_t k = 0; k < count; ++k) {
    const float length = std::sqrt(x[k] * x[k] + y[k] * y[k] + z[k] * z[k]);
    const float at_least = length > kNoLess ? length : kNoLess;
    range[k] = at_least;
    relative_noise[k] = depthNoise(at_least) / at_least;
  }
}

/// What each point gives when it is held against a plane, and how many of them lie where.
NoisyPoints::InlierCount residualsOf(const Eigen::Vector3f& normal, float distance,
                                     const NoisyPoints::Band& band, std::size_t count,
                                     const float* __restrict x, const float* __restrict y,
                                     const float* __restrict z, const float* __restrict range,
                                     const float* __restrict relative_noise, float* __restrict sigmas,
                                     float* __restrict heights, std::int32_t* __restrict on)
{
  // A point below this is under the floor and no noise of it: 5 cm, and 2 cm more for each metre of range.
  constexpr float kBelowBase = 0.05F;
  constexpr float kBelowPerMetre = 0.02F;
  constexpr float kBelowSigmas = 3.0F;
  // What the noise model does not hold, quantisation and a lens that bends far floors: without it the nearest
  // points would decide alone, and a far floor would stand out of a plane that is tangential to the near one.
  constexpr float kLeastSigma = 0.003F;          // [m]
  constexpr float kLeastSigmaPerMetre = 0.003F;  // [m/m]
  const float nx = normal.x();
  const float ny = normal.y();
  const float nz = normal.z();
  const auto [band_sigmas, widest, deepest] = band;
  NoisyPoints::InlierCount counts;
  for (std::size_t k = 0; k < count; ++k) {
    const float along = nx * x[k] + ny * y[k] + nz * z[k];
    const float noise = relative_noise[k] * std::abs(along);
    const float sigma = noise + kLeastSigma + kLeastSigmaPerMetre * range[k];
    const float wide = band_sigmas * sigma;
    const float half_width = wide < widest ? wide : widest;
    const float height = along + distance;
    const float margin = kBelowBase + kBelowPerMetre * range[k] + kBelowSigmas * noise;
    sigmas[k] = sigma;
    heights[k] = height;
    const std::int32_t in_band = std::abs(height) < half_width ? 1 : 0;
    on[k] = in_band;
    counts.inliers += in_band;
    counts.below += ((height < -margin) & (-along < deepest + margin)) ? 1 : 0;
  }
  return counts;
}

}  // namespace

void NoisyPoints::resize(std::size_t count)
{
  for (auto* values : {&x_, &y_, &z_}) values->resize(count);
  range_.clear();
  relative_noise_.clear();
}

void NoisyPoints::measure()
{
  const std::size_t first = range_.size();
  range_.resize(size());
  relative_noise_.resize(size());
  measureRanges(size() - first, x_.data() + first, y_.data() + first, z_.data() + first,
                range_.data() + first, relative_noise_.data() + first);
}

void NoisyPoints::computeResiduals(const geometry::Plane& plane, const Band& band)
{
  measure();
  sigma_.resize(size());
  height_.resize(size());
  on_.resize(size());
  camera_height_ = static_cast<float>(plane.distance);
  counts_ =
      residualsOf(plane.normal.cast<float>(), camera_height_, band, size(), x_.data(), y_.data(), z_.data(),
                  range_.data(), relative_noise_.data(), sigma_.data(), height_.data(), on_.data());
}

bool NoisyPoints::runsAlong(std::size_t k, std::size_t neighbour) const
{
  constexpr float kSteepest = 0.35F;  // sine of 20 degrees
  constexpr float kSigmas = 2.0F;
  const float dx = x_[neighbour] - x_[k];
  const float dy = y_[neighbour] - y_[k];
  const float dz = z_[neighbour] - z_[k];
  const float rise =
      std::abs(height_[neighbour] - height_[k]) - kSigmas * relative_noise_[k] * camera_height_;
  // Written so that NaN is no step at all.
  return !(rise > 0.0F && rise * rise > kSteepest * kSteepest * (dx * dx + dy * dy + dz * dz));
}

}  // namespace polygonal_perception::perception

#include "noisy_points.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "depth_noise.hpp"

namespace polygonal_perception {

void NoisyPoints::clear()
{
  for (auto* values : {&x_, &y_, &z_, &range_, &relative_noise_}) values->clear();
}

void NoisyPoints::add(const Eigen::Vector3f& point)
{
  x_.push_back(point.x());
  y_.push_back(point.y());
  z_.push_back(point.z());
}

void NoisyPoints::measure()
{
  constexpr float kNoLess = 1e-3F;  // [m] keeps a point in the camera's centre from a division by zero
  const std::size_t first = range_.size();
  if (first == size()) return;
  range_.resize(size());
  relative_noise_.resize(size());
  for (std::size_t k = first; k < size(); ++k) {
    range_[k] = std::max(kNoLess, std::sqrt(x_[k] * x_[k] + y_[k] * y_[k] + z_[k] * z_[k]));
    relative_noise_[k] = depthNoise(range_[k]) / range_[k];
  }
}

void NoisyPoints::compare(const Plane& plane, const Band& band)
{
  // A point below this is under the floor and no noise of it: 5 cm, and 2 cm more for each metre of range.
  constexpr float kBelowBase = 0.05F;
  constexpr float kBelowPerMetre = 0.02F;
  constexpr float kBelowSigmas = 3.0F;
  // What the noise model does not hold, quantisation and a lens that bends far floors: without it the nearest
  // points would decide alone, and a far floor would stand out of a plane that is tangential to the near one.
  constexpr float kLeastSigma = 0.003F;          // [m]
  constexpr float kLeastSigmaPerMetre = 0.003F;  // [m/m]
  measure();
  sigma_.resize(size());
  height_.resize(size());
  on_.resize(size());
  below_.resize(size());
  camera_height_ = static_cast<float>(plane.distance);
  const Eigen::Vector3f n = plane.normal.cast<float>();
  const float nx = n.x();
  const float ny = n.y();
  const float nz = n.z();
  const float d = camera_height_;
  // Told that the arrays do not overlap, compilers turn this into vector code: it is most of the floor's
  // time.
  const float* __restrict const x = x_.data();
  const float* __restrict const y = y_.data();
  const float* __restrict const z = z_.data();
  const float* __restrict const range = range_.data();
  const float* __restrict const relative_noise = relative_noise_.data();
  float* __restrict const sigmas = sigma_.data();
  float* __restrict const heights = height_.data();
  std::int32_t* __restrict const on = on_.data();
  std::int32_t* __restrict const below = below_.data();
  const std::size_t count = size();
  for (std::size_t k = 0; k < count; ++k) {
    const float along = nx * x[k] + ny * y[k] + nz * z[k];
    const float noise = relative_noise[k] * std::abs(along);
    const float sigma = noise + kLeastSigma + kLeastSigmaPerMetre * range[k];
    const float half_width = std::min(band.widest, band.sigmas * sigma);
    sigmas[k] = sigma;
    const float height = along + d;
    heights[k] = height;
    on[k] = std::abs(height) < half_width ? 1 : 0;
    const float margin = kBelowBase + kBelowPerMetre * range[k] + kBelowSigmas * noise;
    below[k] = (height < -margin) & (-along < band.deepest + margin) ? 1 : 0;
  }
}

NoisyPoints::Tally NoisyPoints::tally() const
{
  return {std::accumulate(on_.begin(), on_.end(), 0), std::accumulate(below_.begin(), below_.end(), 0)};
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

}  // namespace polygonal_perception

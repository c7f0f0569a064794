#include "noisy_points.hpp"

#include <algorithm>
#include <cmath>

#include "depth_noise.hpp"

namespace polygonal_perception {

namespace {

/// A plane in single precision and the height of points above it.
struct FastPlane
{
  explicit FastPlane(const Plane& plane)
    : nx(static_cast<float>(plane.normal.x())),
      ny(static_cast<float>(plane.normal.y())),
      nz(static_cast<float>(plane.normal.z())),
      d(static_cast<float>(plane.distance))
  {
  }

  float nx, ny, nz, d;
};

/// Half the width of the band at a point: `along` is its coordinate along the normal.
float halfWidth(const NoisyPoints::Band& band, float along, float range, float relative_noise)
{
  return std::min(band.widest,
                  band.base + band.sigmas * relative_noise * std::abs(along) + band.per_metre * range);
}

}  // namespace

void NoisyPoints::clear()
{
  for (auto* values : {&x_, &y_, &z_, &range_, &relative_noise_}) values->clear();
}

void NoisyPoints::reserve(std::size_t count)
{
  for (auto* values : {&x_, &y_, &z_, &range_, &relative_noise_}) values->reserve(count);
}

void NoisyPoints::add(const Eigen::Vector3f& point)
{
  const float range = std::max(1e-3F, point.norm());
  x_.push_back(point.x());
  y_.push_back(point.y());
  z_.push_back(point.z());
  range_.push_back(range);
  relative_noise_.push_back(depthNoise(range) / range);
}

NoisyPoints::Tally NoisyPoints::tally(const Plane& plane, const Band& band) const
{
  // A point below this is under the floor and no noise of it: 5 cm, and 2 cm more for each metre of range.
  constexpr float kBelowBase = 0.05F;
  constexpr float kBelowPerMetre = 0.02F;
  const FastPlane fast(plane);
  int on = 0;
  int below = 0;
  for (std::size_t k = 0; k < x_.size(); ++k) {
    const float along = fast.nx * x_[k] + fast.ny * y_[k] + fast.nz * z_[k];
    const float height = along + fast.d;
    on += std::abs(height) < halfWidth(band, along, range_[k], relative_noise_[k]) ? 1 : 0;
    const float noise = 3.0F * relative_noise_[k] * std::abs(along);
    below += height < -(kBelowBase + kBelowPerMetre * range_[k] + noise) ? 1 : 0;
  }
  return {on, below};
}

bool NoisyPoints::on(std::size_t k, const Plane& plane, const Band& band) const
{
  const FastPlane fast(plane);
  const float along = fast.nx * x_[k] + fast.ny * y_[k] + fast.nz * z_[k];
  return std::abs(along + fast.d) < halfWidth(band, along, range_[k], relative_noise_[k]);
}

PlaneFit NoisyPoints::fit(const Plane& plane, const Band& band) const
{
  constexpr float kLeastSigma = 0.002F;  // [m] what quantisation and calibration leave at any range
  PlaneFit fit;
  for (std::size_t k = 0; k < x_.size(); ++k) {
    if (!on(k, plane, band)) continue;
    const float sigma = relative_noise_[k] * std::abs(static_cast<float>(plane.distance));
    fit.add(x_[k], y_[k], z_[k], 1.0F / (kLeastSigma * kLeastSigma + sigma * sigma));
  }
  return fit;
}

}  // namespace polygonal_perception

#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "perception/planes/plane_fit.hpp"
#include "polygonal_perception/geometry/plane.hpp"
#include "polygonal_perception/perception/input/sensor_noise.hpp"

namespace polygonal_perception::perception {

/// A regular grid of pixels of a depth image with what is known of their noise, laid out so that all of them can be
/// held against a plane in one sweep. A pixel may have no point (NaN); it lies on no plane and below none.
class NoisyPixels
{
public:
  /// How far from a plane a point may lie and still count as one of it.
  struct Band
  {
    float sigmas;  ///< times the standard deviation of its height
    float widest;  ///< [m]
    /// [m], [m/m] what the noise does not hold, a part of that standard deviation
    float model_error;
    float model_error_slope;
  };

  /// Makes room for points that are to be set, and forgets what was measured of earlier ones.
  void resize(std::size_t count, std::size_t columns);
  void set(std::size_t k, const Eigen::Vector3f& point)
  {
    x_[k] = point.x();
    y_[k] = point.y();
    z_[k] = point.z();
  }
  /// Measures the points once all are set.
  void measure(const SensorNoise& noise);

  std::size_t size() const { return x_.size(); }

  /// Holds all points against a plane. What follows speaks of this plane and band until the next call.
  void computeResiduals(const geometry::Plane& plane, const Band& band);

  /// Holds only some points against another plane; what follows speaks of it for them.
  void computeResidualsOf(const std::vector<std::uint32_t>& points, const geometry::Plane& plane,
                          const Band& band);

  /// Takes those points out of the band that lie nearer to another plane.
  void giveTo(const geometry::Plane& other);

  /// Whether point k lies in the band.
  bool on(std::size_t k) const { return on_[k] != 0; }

  /// How many lie in the band.
  std::size_t inliers() const { return inliers_; }

  /// Whether the surface at pixel k runs along the plane rather than across it, up to the rows above and below. A
  /// neighbour without a point says nothing against it.
  /// @param steepest  sine of the largest angle
  /// @param sigmas    standard deviations that noise may add
  bool liesFlat(std::size_t k, float steepest, float sigmas) const
  {
    return (k < columns_ || runsAlong(k, k - columns_, steepest, sigmas)) &&
           (k + columns_ >= size() || runsAlong(k, k + columns_, steepest, sigmas));
  }

  /// Picks accepted points in the band.
  /// @param accept  called with the index of a point in the band
  /// @param enough  of a band that holds more points than twice this, only every second, third, ... is looked
  ///                at
  /// @param picked  their indices, filled anew
  /// @return how many points were looked at
  template <class Accept>
  std::size_t pick(Accept&& accept, std::size_t enough, std::vector<std::uint32_t>& picked) const
  {
    // Without a branch for each point: whether it is in the band is anybody's guess.
    picked.resize(size());
    std::size_t in_band = 0;
    for (std::uint32_t k = 0; k < size(); ++k) {
      picked[in_band] = k;
      in_band += static_cast<std::size_t>(on_[k]);
    }
    const std::size_t step = std::max<std::size_t>(1, in_band / std::max<std::size_t>(1, enough));
    std::size_t looked_at = 0;
    std::size_t accepted = 0;
    for (std::size_t i = 0; i < in_band; i += step) {
      const std::uint32_t k = picked[i];
      ++looked_at;
      if (accept(k)) picked[accepted++] = k;
    }
    picked.resize(accepted);
    return looked_at;
  }

  /// Calls visit(k, height, sigma) for each point that lies below the plane by more than so many standard deviations
  /// of its height, its noise and a model error of `slope` times its range.
  template <class Visit>
  void forEachBelow(float sigmas, float slope, Visit&& visit) const
  {
    for (std::size_t k = 0; k < size(); ++k) {
      if (!(height_[k] < 0.0F)) continue;
      const float noise = relative_noise_[k] * (camera_height_ - height_[k]);
      const float model = slope * range_[k];
      const float sigma = std::sqrt(noise * noise + model * model);
      if (height_[k] < -sigmas * sigma) visit(k, height_[k], sigma);
    }
  }

  /// Distance of point k from the plane in units of its standard deviation.
  float normalizedResidual(std::size_t k) const { return std::abs(height_[k]) / sigma_[k]; }

  /// Adds point k to a fit, weighted by the inverse variance of its height.
  void addTo(PlaneFit& fit, std::size_t k) const
  {
    fit.add(x_[k], y_[k], z_[k], 1.0F / (sigma_[k] * sigma_[k]));
  }

private:
  bool runsAlong(std::size_t k, std::size_t neighbour, float steepest, float sigmas) const;

  std::size_t columns_ = 0;
  std::vector<float> x_, y_, z_;
  std::vector<float> range_, relative_noise_;  // [m], and standard deviation of the depth over the range
  // What the last comparison gave.
  float camera_height_ = 0.0F;
  std::vector<float> height_;
  std::vector<float> sigma_;  // standard deviation of the height
  std::vector<std::int32_t> on_;
  std::size_t inliers_ = 0;
};

}  // namespace polygonal_perception::perception

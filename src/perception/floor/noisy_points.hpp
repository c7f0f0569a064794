#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "perception/floor/plane_fit.hpp"
#include "polygonal_perception/geometry/plane.hpp"

namespace polygonal_perception::perception {

/// Points of a depth camera with what is known of their noise, laid out so that all of them can be held
/// against a plane in one sweep. A point may be NaN; it lies on no plane and below none.
///
/// Depth noise moves a point along its viewing ray, so its height above a plane errs by only the part of that
/// which is along the normal: on a floor seen at a grazing angle a small one.
class NoisyPoints
{
public:
  /// How far from a plane a point may lie and still count as one of it.
  struct Band
  {
    float sigmas;  ///< times the standard deviation of its height
    float widest;  ///< [m]
    /// [m] What lies deeper than this under the camera does not count as below the plane: it is beyond every
    /// floor that the camera can stand on.
    float deepest;
  };

  /// How the points lie about a plane.
  struct InlierCount
  {
    int inliers = 0;  ///< in the band
    int below = 0;    ///< clearly below the plane
  };

  /// Makes room for points that are to be set, and forgets what was measured of earlier ones.
  void resize(std::size_t count);
  void set(std::size_t k, const Eigen::Vector3f& point)
  {
    x_[k] = point.x();
    y_[k] = point.y();
    z_[k] = point.z();
  }

  void clear() { resize(0); }
  void add(const Eigen::Vector3f& point)
  {
    x_.push_back(point.x());
    y_.push_back(point.y());
    z_.push_back(point.z());
  }
  std::size_t size() const { return x_.size(); }

  /// Holds all points against a plane. What follows speaks of this plane and band until the next call.
  void computeResiduals(const geometry::Plane& plane, const Band& band);

  /// Whether point k lies in the band.
  bool on(std::size_t k) const { return on_[k] != 0; }

  /// The points in the band and below the plane.
  const InlierCount& counts() const { return counts_; }

  /// Whether the surface between points k and neighbour runs along the plane rather than across it. A
  /// neighbour without a return says nothing against it.
  bool runsAlong(std::size_t k, std::size_t neighbour) const;

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

  /// Distance of point k from the plane in units of its standard deviation.
  float normalizedResidual(std::size_t k) const { return std::abs(height_[k]) / sigma_[k]; }

  /// Adds point k to a fit, weighted by the inverse variance of its height.
  void addTo(PlaneFit& fit, std::size_t k) const
  {
    fit.add(x_[k], y_[k], z_[k], 1.0F / (sigma_[k] * sigma_[k]));
  }

private:
  void measure();

  std::vector<float> x_, y_, z_;
  std::vector<float> range_, relative_noise_;  // [m], and standard deviation of the depth over the range
  // What the last comparison gave.
  float camera_height_ = 0.0F;
  std::vector<float> height_;
  std::vector<float> sigma_;  // standard deviation of the height
  std::vector<std::int32_t> on_;
  InlierCount counts_;
};

}  // namespace polygonal_perception::perception

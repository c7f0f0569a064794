#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "plane_fit.hpp"
#include "polygonal_perception/plane.hpp"

namespace polygonal_perception {

/// Points of a depth camera with what is known of their noise, laid out so that all of them can be held against a plane
/// in one sweep.
///
/// Depth noise moves a point along its viewing ray, so its height above a plane errs by only the part of that which is
/// along the normal: on a floor seen at a grazing angle a small one.
class NoisyPoints
{
public:
  /// How far from a plane a point may lie and still count as one of it.
  struct Band
  {
    float base;        ///< [m]
    float sigmas;      ///< times the standard deviation of its height
    float per_metre;   ///< [m/m] times its range: lens distortion bends far floors
    float widest;      ///< [m]
  };

  /// How the points lie about a plane.
  struct Tally
  {
    int on = 0;     ///< in the band
    int below = 0;  ///< clearly below the plane
  };

  void clear();
  void reserve(std::size_t count);
  void add(const Eigen::Vector3f& point);
  std::size_t size() const { return x_.size(); }

  /// Counts the points on and below a plane.
  Tally tally(const Plane& plane, const Band& band) const;

  /// Collects the points in the band about a plane, each weighted by the inverse variance of its height.
  PlaneFit fit(const Plane& plane, const Band& band) const;

  Eigen::Vector3f point(std::size_t k) const { return {x_[k], y_[k], z_[k]}; }
  float range(std::size_t k) const { return range_[k]; }
  /// Standard deviation of the point's depth over its range.
  float relativeNoise(std::size_t k) const { return relative_noise_[k]; }

  /// Whether point k lies in the band about a plane.
  bool on(std::size_t k, const Plane& plane, const Band& band) const;

private:
  std::vector<float> x_, y_, z_, range_, relative_noise_;
};

}  // namespace polygonal_perception

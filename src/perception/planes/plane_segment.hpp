#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "perception/planes/noisy_sample.hpp"
#include "perception/planes/plane_fit.hpp"

namespace polygonal_perception::perception {

/// Samples that lie on one plane, and their fit.
struct PlaneSegment
{
  PlaneFit points;
  PlaneFit::Result fit;

  /// Adds a sample, weighted by its variance about a plane of that normal.
  void add(const NoisySample& sample, const Eigen::Vector3f& normal)
  {
    points.add(sample.point.x(), sample.point.y(), sample.point.z(),
               1.0F / sample.variance(normal.dot(sample.point)));
  }

  /// Fits the plane to its samples.
  /// @return whether they make one; if not, the fit stays what it was
  bool refit(const Eigen::Vector3d& towards_camera, const PlaneExtractionParameters& parameters)
  {
    if (static_cast<double>(points.count()) < parameters.least_samples) return false;
    const auto solution = points.solve(towards_camera);
    if (!solution || solution->plane.distance < parameters.least_view_angle * solution->centre.norm())
      return false;
    fit = *solution;
    return true;
  }
};

/// The segments of a frame, and which of them each sample belongs to.
struct PlaneSegments
{
  static constexpr int kNone = -1;

  std::vector<PlaneSegment> all;
  std::vector<int> of_sample;

  /// Numbers the segments anew: `to` has the new number of each, or kNone.
  void renumber(const std::vector<int>& to)
  {
    for (int& segment : of_sample) {
      if (segment != kNone) segment = to[static_cast<std::size_t>(segment)];
    }
  }
};

}  // namespace polygonal_perception::perception

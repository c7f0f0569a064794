#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "perception/floor/noisy_pixels.hpp"
#include "perception/planes/plane_fit.hpp"
#include "polygonal_perception/perception/floor/floor_refinement_parameters.hpp"
#include "polygonal_perception/perception/input/point_view.hpp"

namespace polygonal_perception::perception {

/// The final fit of the floor (algorithm 2, line 16): least squares over many more pixels than the samples, weighted by
/// their noise, without what is merely close to the floor.
class FloorRefinement
{
public:
  using Parameters = FloorRefinementParameters;

  struct Result
  {
    PlaneFit::Result fit;
    Eigen::Matrix4d covariance;  // of the normal's three components [1] and the distance [m]
  };

  /// Takes the pixels of a frame.
  void take(const PointView& points, const SensorNoise& noise);

  /// @param rough   a plane that is near the floor
  /// @param rivals  other planes of the frame, which keep the pixels that lie nearer to them
  /// @return nothing where the pixels do not bear a floor out: too few, too narrow, the normal uncertain
  std::optional<Result> refine(const geometry::Plane& rough, const std::vector<geometry::Plane>& rivals,
                               const Parameters& parameters);

  /// Looks for a floor below a platform of which so narrow a strip is seen that the samples miss it.
  /// @param platform  its plane; the floor is parallel to it, and its tilt is taken over where the strip does not tell
  /// @param deepest   [m] below the camera
  std::optional<Result> findStripBelow(const geometry::Plane& platform, double deepest,
                                       const Parameters& parameters);

private:
  void pickInliers(const Parameters& parameters);
  PlaneFit fitClipped(const Parameters& parameters) const;
  float medianDeviation() const;
  std::optional<double> heightOfStrip(const Parameters& parameters);

  NoisyPixels pixels_;
  std::vector<std::uint32_t> picked_;
  double flat_ = 0.0;                // share of the inliers along which the surface runs
  std::vector<float> below_;         // [m] heights of the pixels clearly below a platform
  std::vector<float> nearly_below_;  // and less clearly
  float below_sigma_ = 0.0F;         // [m] their mean standard deviation
};

}  // namespace polygonal_perception::perception

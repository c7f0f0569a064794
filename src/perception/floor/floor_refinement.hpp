#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "perception/floor/noisy_points.hpp"
#include "perception/floor/plane_fit.hpp"
#include "polygonal_perception/perception/floor/floor_detector.hpp"
#include "polygonal_perception/perception/input/point_view.hpp"

namespace polygonal_perception::perception {

/// The final fit of the floor (algorithm 2, line 16): total least squares over many more pixels than the
/// samples, weighted by their noise, without what is merely close to the floor.
class FloorRefinement
{
public:
  struct Result
  {
    PlaneFit::Result fit;
    NoisyPoints::InlierCount counts;  // of the pixels about the plane
  };

  /// Takes the pixels of a frame.
  void take(const PointView& points);

  /// @param rough  a plane that is near the floor
  /// @return nothing where the pixels do not bear a floor out: too few, too narrow, the normal uncertain
  std::optional<Result> refine(const geometry::Plane& rough, const FloorDetector::Parameters& parameters);

private:
  bool liesFlat(std::size_t k) const;
  float medianDeviation() const;

  NoisyPoints pixels_;  // a regular grid of them, NaN where there is no return
  std::size_t columns_ = 0;
  std::vector<std::uint32_t> picked_;
};

}  // namespace polygonal_perception::perception

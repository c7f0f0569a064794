#include "perception/floor/floor_absence.hpp"

#include <algorithm>

#include "perception/floor/floor_selection.hpp"
#include "polygonal_perception/geometry/angle.hpp"

namespace polygonal_perception::perception {

FloorAbsence explainAbsence(const PlaneExtraction& extraction, const FloorSelectionParameters& parameters,
                            const FloorPrior& prior)
{
  FloorAbsence absence;
  const std::vector<NoisySample>& samples = extraction.samples().all;
  const auto points = std::count_if(samples.begin(), samples.end(),
                                    [](const NoisySample& sample) { return sample.has_point; });
  if (!samples.empty())
    absence.point_share = static_cast<double>(points) / static_cast<double>(samples.size());

  const double max_tilt = prior.maxTiltWith(parameters);
  const auto facesUp = [&](const ExtractedPlane& plane) {
    return geometry::angleBetween(plane.fit.plane.normal, prior.up) <= max_tilt;
  };
  const auto largest = std::max_element(extraction.planes().begin(), extraction.planes().end(),
                                        [&](const ExtractedPlane& a, const ExtractedPlane& b) {
                                          return facesUp(a) != facesUp(b) ? facesUp(b) : a.size < b.size;
                                        });
  if (largest == extraction.planes().end()) return absence;

  const geometry::Plane& plane = largest->fit.plane;
  absence.normal = plane.normal;
  absence.tilt = geometry::angleBetween(plane.normal, prior.up);
  absence.up_is_from_tf = prior.level.has_value();
  absence.height = plane.distance;
  const HeightBounds bounds = prior.boundsWith(parameters);
  absence.lowest = bounds.lowest;
  absence.highest = bounds.highest;
  absence.bounds_are_mounts = prior.bounds.has_value();
  using Reason = FloorAbsence::Reason;
  if (!facesUp(*largest)) {
    absence.reason = Reason::kNoneFacesUp;
  } else if (contradictsTf(plane, parameters, prior)) {
    absence.reason = Reason::kNotLevelInTf;
    absence.tilt = geometry::angleBetween(plane.normal, *prior.level);
  } else if (plane.distance < bounds.lowest) {
    absence.reason = Reason::kTooNear;
  } else {
    absence.reason = plane.distance > bounds.highest ? Reason::kTooFar : Reason::kUnlikely;
  }
  return absence;
}

}  // namespace polygonal_perception::perception

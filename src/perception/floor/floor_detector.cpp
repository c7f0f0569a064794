#include "polygonal_perception/perception/floor/floor_detector.hpp"

#include "perception/floor/floor_refinement.hpp"
#include "perception/floor/floor_selection.hpp"
#include "perception/planes/plane_extraction.hpp"
#include "polygonal_perception/geometry/angle.hpp"

namespace polygonal_perception::perception {

struct FloorDetector::Workspace
{
  PlaneExtraction extraction;
  FloorSelection selection;
  FloorRefinement refinement;
  std::vector<geometry::Plane> rivals;

  std::optional<FloorRefinement::Result> refine(const FloorCandidate& candidate, const Parameters& parameters,
                                                const FloorPrior& prior);
  void findRivals(const geometry::Plane& plane, const FloorRefinementParameters& parameters);
  std::uint32_t label(const geometry::Plane* floor, int floor_index,
                      const PlaneExtractionParameters& parameters, std::vector<SampleLabel>& labels) const;
};

FloorDetector::FloorDetector(const Parameters& parameters)
    : parameters_(parameters), workspace_(std::make_unique<Workspace>())
{
}
FloorDetector::FloorDetector(FloorDetector&& other) noexcept = default;
FloorDetector& FloorDetector::operator=(FloorDetector&& other) noexcept = default;
FloorDetector::~FloorDetector() = default;

std::optional<DetectedFloor> FloorDetector::detect(const PointView& points, const SampleGrid& grid,
                                                   const FloorPrior& prior)
{
  auto& [extraction, selection, refinement, rivals] = *workspace_;
  std::optional<geometry::Plane> last;
  if (prior.height && prior.up_is_measured) last = geometry::Plane{prior.up, *prior.height};
  extraction.extract(grid, parameters_.planes, last);
  selection.rate(extraction, parameters_.selection, prior);

  std::optional<DetectedFloor> floor;
  int floor_index = PlaneSegments::kNone;
  FloorCandidate* candidate = selection.best(parameters_.selection);
  if (candidate != nullptr) refinement.take(points, parameters_.planes.noise);
  for (; candidate != nullptr && !floor; candidate = selection.best(parameters_.selection)) {
    candidate->refused = true;
    const auto refined = workspace_->refine(*candidate, parameters_, prior);
    if (!refined) continue;
    const PlaneFit::Result& fit = refined->fit;
    floor_index = candidate->index;
    floor.emplace();
    floor->plane = fit.plane;
    floor->rms_error = fit.rms_error;
    floor->covariance = refined->covariance;
    floor->continued = candidate->continues;
    floor->others = selection.others(fit.plane, parameters_.selection);
  }
  const std::uint32_t count =
      workspace_->label(floor ? &floor->plane : nullptr, floor_index, parameters_.planes, labels_);
  if (floor) floor->sample_count = count;
  return floor;
}

std::optional<FloorRefinement::Result> FloorDetector::Workspace::refine(const FloorCandidate& candidate,
                                                                        const Parameters& parameters,
                                                                        const FloorPrior& prior)
{
  const double deepest = parameters.selection.max_camera_height;
  const auto fits_the_camera = [&](const std::optional<FloorRefinement::Result>& result) {
    return result && result->fit.plane.distance >= parameters.selection.min_camera_height &&
           result->fit.plane.distance <= deepest;
  };
  findRivals(candidate.fit.plane, parameters.refinement);
  auto fit = refinement.refine(candidate.fit.plane, rivals, parameters.refinement);
  if (!fits_the_camera(fit)) return std::nullopt;
  // A robot that has seen its floor for a while looks at a drop, and so does one above stairs.
  if ((prior.confirmed && candidate.continues) || candidate.leads_down) return fit;
  auto strip = refinement.findStripBelow(fit->fit.plane, deepest, parameters.refinement);
  return fits_the_camera(strip) ? strip : fit;
}

void FloorDetector::Workspace::findRivals(const geometry::Plane& plane,
                                          const FloorRefinementParameters& parameters)
{
  rivals.clear();
  for (const ExtractedPlane& other : extraction.planes()) {
    const double offset = std::abs(plane.height(other.fit.centre));
    if (offset > parameters.nearest_rival && offset < parameters.farthest_rival &&
        geometry::angleBetween(other.fit.plane.normal, plane.normal) < parameters.rival_angle) {
      rivals.push_back(other.fit.plane);
    }
  }
}

/// @param floor  none: no floor was found
/// @return how many samples are the floor's
std::uint32_t FloorDetector::Workspace::label(const geometry::Plane* floor, int floor_index,
                                              const PlaneExtractionParameters& parameters,
                                              std::vector<SampleLabel>& labels) const
{
  const NoisySamples& samples = extraction.samples();
  labels.assign(samples.size(), SampleLabel::kNoPoint);
  const Eigen::Vector3f normal =
      floor != nullptr ? Eigen::Vector3f(floor->normal.cast<float>()) : Eigen::Vector3f::Zero();
  const auto is_level = [&](int plane) {
    return plane != PlaneSegments::kNone && selection.isCandidate(static_cast<std::size_t>(plane));
  };
  std::uint32_t count = 0;
  for (std::uint32_t k = 0; k < samples.size(); ++k) {
    const NoisySample& sample = samples[k];
    const int plane = extraction.planeOf()[k];
    if (!sample.has_point) continue;
    labels[k] = is_level(plane) ? SampleLabel::kSegment : SampleLabel::kPruned;
    if (floor == nullptr || !sample.has_normal || sample.normal.dot(normal) < parameters.normal_cosine)
      continue;
    const float along = normal.dot(sample.point);
    const double height = along + floor->distance;
    if (plane != floor_index &&
        height * height > parameters.inlier_sigmas * parameters.inlier_sigmas * sample.variance(along)) {
      continue;
    }
    labels[k] = SampleLabel::kFloor;
    ++count;
  }
  return count;
}

}  // namespace polygonal_perception::perception

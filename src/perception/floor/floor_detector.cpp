#include "polygonal_perception/perception/floor/floor_detector.hpp"

#include <cmath>

#include "perception/floor/floor_absence.hpp"
#include "perception/floor/floor_refinement.hpp"
#include "perception/floor/floor_selection.hpp"
#include "perception/planes/plane_extraction.hpp"
#include "polygonal_perception/geometry/angle.hpp"

namespace polygonal_perception::perception {

namespace {

/// Does a floor that is no candidate's own plane lie where the last one was?
bool continuesLast(const geometry::Plane& floor, double turn, const FloorPrior& prior)
{
  return prior.height && std::abs(*prior.height - floor.distance) < prior.height_tolerance &&
         (!prior.last || geometry::angleBetween(floor.normal, prior.last->normal) < turn);
}

}  // namespace

struct FloorDetector::Workspace
{
  /// A candidate after its fit through the cloud, or the strip of floor that lies below it.
  struct Refined
  {
    FloorRefinement::Result result;
    bool is_strip = false;
  };

  PlaneExtraction extraction;
  FloorSelection selection;
  FloorRefinement refinement;
  std::vector<geometry::Plane> rivals;

  std::optional<Refined> refine(const FloorCandidate& candidate, const Parameters& parameters,
                                const FloorPrior& prior);
  void findRivals(const geometry::Plane& plane, const FloorRefinementParameters& parameters);
  std::uint32_t label(const geometry::Plane* floor, std::optional<int> own_plane,
                      const PlaneExtractionParameters& parameters, std::vector<SampleLabel>& labels) const;
};

FloorDetector::FloorDetector(const Parameters& parameters)
    : parameters_(parameters), workspace_(std::make_unique<Workspace>())
{
}
FloorDetector::FloorDetector(FloorDetector&& other) noexcept = default;
FloorDetector& FloorDetector::operator=(FloorDetector&& other) noexcept = default;
FloorDetector::~FloorDetector() = default;

const PlaneExtraction& FloorDetector::extraction() const
{
  return workspace_->extraction;
}

FloorAbsence FloorDetector::absence(const FloorPrior& prior) const
{
  return explainAbsence(workspace_->extraction, parameters_.selection, prior);
}

std::optional<DetectedFloor> FloorDetector::detect(const PointView& points, const SampleGrid& grid,
                                                   const FloorPrior& prior)
{
  auto& [extraction, selection, refinement, rivals] = *workspace_;
  extraction.extract(grid, parameters_.planes, prior.last);
  selection.rate(extraction, parameters_.selection, prior);

  std::optional<DetectedFloor> floor;
  std::optional<int> own_plane;
  FloorCandidate* candidate = selection.best(parameters_.selection);
  if (candidate != nullptr) refinement.take(points, parameters_.planes.noise);
  for (; candidate != nullptr && !floor; candidate = selection.best(parameters_.selection)) {
    candidate->refused = true;
    const auto refined = workspace_->refine(*candidate, parameters_, prior);
    if (!refined) continue;
    const PlaneFit::Result& fit = refined->result.fit;
    if (!refined->is_strip) own_plane = candidate->index;
    floor.emplace();
    floor->plane = fit.plane;
    floor->rms_error = fit.rms_error;
    floor->covariance = refined->result.covariance;
    floor->continued = refined->is_strip ? continuesLast(fit.plane, parameters_.selection.turn, prior)
                                         : candidate->continues;
    floor->others = selection.others(fit.plane, parameters_.selection);
  }
  const std::uint32_t count =
      workspace_->label(floor ? &floor->plane : nullptr, own_plane, parameters_.planes, labels_);
  if (floor) floor->sample_count = count;
  return floor;
}

std::optional<FloorDetector::Workspace::Refined> FloorDetector::Workspace::refine(
    const FloorCandidate& candidate, const Parameters& parameters, const FloorPrior& prior)
{
  const HeightBounds bounds = prior.boundsWith(parameters.selection);
  const auto fits_the_camera = [&](const std::optional<FloorRefinement::Result>& result) {
    return result && bounds.contain(result->fit.plane.distance) &&
           geometry::angleBetween(result->fit.plane.normal, prior.up) <= prior.max_tilt.value_or(M_PI);
  };
  findRivals(candidate.fit.plane, parameters.refinement);
  const auto fit = refinement.refine(candidate.fit.plane, rivals, parameters.refinement);
  if (!fits_the_camera(fit)) return std::nullopt;
  // A robot that has seen its floor for a while looks at a drop, and so does one above stairs.
  if ((prior.confirmed && candidate.continues) || candidate.leads_down) return Refined{*fit};
  const auto strip = refinement.findStripBelow(fit->fit.plane, bounds.highest, parameters.refinement);
  if (fits_the_camera(strip)) return Refined{*strip, true};
  return Refined{*fit};
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

/// @param floor      none: no floor was found
/// @param own_plane  the extracted plane whose samples are the floor's whatever their height; a strip has none
/// @return how many samples are the floor's
std::uint32_t FloorDetector::Workspace::label(const geometry::Plane* floor, std::optional<int> own_plane,
                                              const PlaneExtractionParameters& parameters,
                                              std::vector<SampleLabel>& labels) const
{
  const NoisySamples& samples = extraction.samples();
  labels.assign(samples.size(), SampleLabel::kNoPoint);
  std::optional<ReferencePlane> reference;
  if (floor != nullptr) reference.emplace(*floor);
  const auto squared_sigmas = static_cast<float>(parameters.inlier_sigmas * parameters.inlier_sigmas);
  const auto is_level = [&](int plane) {
    return plane != PlaneSegments::kNone && selection.isCandidate(static_cast<std::size_t>(plane));
  };
  std::uint32_t count = 0;
  for (std::uint32_t k = 0; k < samples.size(); ++k) {
    const NoisySample& sample = samples[k];
    const int plane = extraction.planeOf()[k];
    if (!sample.has_point) continue;
    labels[k] = is_level(plane) ? SampleLabel::kSegment : SampleLabel::kPruned;
    if (!reference || !sample.has_normal ||
        !(sample.normal.dot(reference->normal) >= parameters.normal_cosine))
      continue;
    if (plane != own_plane && !(reference->deviation(sample) <= squared_sigmas)) continue;
    labels[k] = SampleLabel::kFloor;
    ++count;
  }
  return count;
}

}  // namespace polygonal_perception::perception

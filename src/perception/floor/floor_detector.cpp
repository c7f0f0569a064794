#include "polygonal_perception/perception/floor/floor_detector.hpp"

#include "perception/floor/floor_candidates.hpp"
#include "perception/floor/floor_refinement.hpp"

namespace polygonal_perception::perception {

struct FloorDetector::Workspace
{
  FloorCandidates candidates;
  FloorRefinement refinement;
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
  FloorCandidates& candidates = workspace_->candidates;
  FloorRefinement& refinement = workspace_->refinement;
  std::optional<DetectedFloor> floor;
  candidates.collect(grid, parameters_, prior);
  if (!candidates.empty()) refinement.take(points);
  for (auto* candidate = candidates.best(prior); candidate != nullptr && !floor;
       candidate = candidates.best(prior)) {
    const auto refined = refinement.refine(candidate->plane, parameters_);
    const bool may_have_more_below = (prior.confirmed && candidate->continues) || candidate->is_stair_top;
    if (refined && isAtCameraHeight(refined->fit.plane, parameters_) &&
        (may_have_more_below || isLowest(refined->fit.plane, refined->counts, parameters_))) {
      floor.emplace();
      floor->plane = refined->fit.plane;
      floor->rms_error = refined->fit.rms_error;
      floor->continued = candidate->continues;
      floor->others = candidates.others(floor->plane);
    }
    candidate->refused = true;
  }
  const auto plane = floor ? std::optional<geometry::Plane>(floor->plane) : std::nullopt;
  const std::uint32_t count = candidates.label(plane, parameters_, labels_);
  if (floor) floor->sample_count = count;
  return floor;
}

}  // namespace polygonal_perception::perception

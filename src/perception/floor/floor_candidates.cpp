#include "perception/floor/floor_candidates.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "perception/floor/plane_fit.hpp"

namespace polygonal_perception::perception {

namespace {

/// A sample's normal is noisy, so it may tilt this much more than the floor itself.
constexpr double kNormalSlack = 0.15;  // [rad]
/// A seed is a rough guess of the camera's attitude: a floor may tilt this much more from it than from a
/// measured up.
constexpr double kSeedSlack = 0.15;  // [rad]
/// The floor's normal turns less than this between two frames of a camera that is moved by hand. What is not
/// the lowest plane of the frame must look more like the last floor to be taken for it.
constexpr double kTurn = 0.26;        // [rad] 15 degrees
constexpr double kTurnAtDrop = 0.08;  // [rad]

constexpr std::size_t kMostCandidates = 8;
constexpr std::uint32_t kSmallestSegment = 4;
/// The least share of all samples that must lie on a floor, and how many of those must have a normal that
/// agrees.
constexpr double kLeastSupport = 0.006;
constexpr double kLeastAgreeing = 0.4;
/// Cosine of the largest angle between a plane's normal and that of a sample that belongs to it: 26 degrees,
/// two and a half times the noise of a sample's normal 4 m away.
constexpr float kAgree = 0.9F;
/// A point this many standard deviations off a plane is not of it.
constexpr float kOnSigmas = 3.0F;
/// Below the lowest floor that the camera can stand on less this, nothing can be the floor instead of a
/// plane.
constexpr double kNothingBetween = 0.3;  // [m]

}  // namespace

NoisyPoints::Band bandOf(const FloorDetector::Parameters& parameters)
{
  return {kOnSigmas, static_cast<float>(parameters.merge_distance),
          static_cast<float>(parameters.max_camera_height)};
}

bool isAtCameraHeight(const geometry::Plane& plane, const FloorDetector::Parameters& parameters)
{
  return plane.distance >= parameters.min_camera_height && plane.distance <= parameters.max_camera_height;
}

bool isLowest(const geometry::Plane& plane, const NoisyPoints::InlierCount& counts,
              const FloorDetector::Parameters& parameters)
{
  return plane.distance > parameters.max_camera_height - kNothingBetween ||
         counts.below * parameters.replacement_factor <= counts.inliers;
}

void FloorCandidates::collect(const SampleGrid& grid, const FloorDetector::Parameters& parameters,
                              const FloorPrior& prior)
{
  const double gate = parameters.max_tilt + kNormalSlack + (prior.up_is_measured ? 0.0 : kSeedSlack);
  segmentation_.segment(grid, prior.up.cast<float>(), static_cast<float>(std::cos(gate)),
                        static_cast<float>(parameters.cluster_distance));
  takeSamples(grid);
  lowest_possible_ = parameters.max_camera_height - kNothingBetween;

  candidates_.clear();
  candidates_.reserve(kMostCandidates + 1);
  too_low_.clear();
  too_low_.reserve(2 * kMostCandidates + 1);
  if (prior.height && prior.up_is_measured) examine({prior.up, *prior.height}, parameters, prior);
  const auto& segments = segmentation_.segments();
  by_size_.clear();
  for (std::uint32_t s = 0; s < segments.size(); ++s) {
    if (segments[s].size >= kSmallestSegment) by_size_.push_back(s);
  }
  std::sort(by_size_.begin(), by_size_.end(),
            [&](std::uint32_t a, std::uint32_t b) { return segments[a].size > segments[b].size; });
  for (const std::uint32_t s : by_size_) {
    if (candidates_.size() >= kMostCandidates) break;
    if (isCovered(grid, segments[s])) continue;
    if (const auto plane = planeOf(grid, segments[s], prior)) examine(*plane, parameters, prior);
  }
  rejectStairSteps(candidates_, too_low_);
}

void FloorCandidates::takeSamples(const SampleGrid& grid)
{
  samples_.clear();
  sample_index_.clear();
  normals_.clear();
  for (std::uint32_t k = 0; k < grid.samples().size(); ++k) {
    const Sample& sample = grid.samples()[k];
    if (!sample.has_point) continue;
    const bool upright = segmentation_.segmentOf()[k] != Segmentation::kNone;
    samples_.add(sample.point);
    sample_index_.push_back(k);
    normals_.push_back(upright ? sample.normal : Eigen::Vector3f::Zero());
  }
}

bool FloorCandidates::isCovered(const SampleGrid& grid, const Segmentation::Segment& segment) const
{
  constexpr double kSameDistance = 0.02;  // [m]
  constexpr float kSameNormal = 0.998F;   // cosine of 3.6 degrees
  const auto& members = segmentation_.members();
  return std::any_of(candidates_.begin(), candidates_.end(), [&](const FloorCandidate& candidate) {
    std::uint32_t shared = 0;
    for (std::uint32_t k = segment.first; k < segment.first + segment.size; ++k) {
      const Sample& sample = grid.samples()[members[k]];
      shared += std::abs(candidate.plane.height(sample.point.cast<double>())) < kSameDistance &&
                        sample.normal.dot(candidate.plane.normal.cast<float>()) > kSameNormal
                    ? 1
                    : 0;
    }
    return 2 * shared > segment.size;
  });
}

std::optional<geometry::Plane> FloorCandidates::planeOf(const SampleGrid& grid,
                                                        const Segmentation::Segment& segment,
                                                        const FloorPrior& prior) const
{
  // Up to here the fit is worth more than the mean of the normals.
  constexpr double kUncertain = 0.03;  // [rad]
  const auto& members = segmentation_.members();
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  PlaneFit fit;
  for (std::uint32_t k = segment.first; k < segment.first + segment.size; ++k) {
    const Sample& sample = grid.samples()[members[k]];
    point += sample.point.cast<double>();
    normal += sample.normal.cast<double>();
    fit.add(sample.point.x(), sample.point.y(), sample.point.z(), 1.0F / sample.point.squaredNorm());
  }
  const auto solution = fit.solve(prior.up);
  if (solution && solution->normal_sigma < kUncertain) return solution->plane;
  if (!(normal.norm() > 0.0)) return std::nullopt;
  normal.normalize();
  return geometry::Plane{normal, -normal.dot(point) / segment.size};
}

void FloorCandidates::examine(const geometry::Plane& hypothesis, const FloorDetector::Parameters& parameters,
                              const FloorPrior& prior)
{
  constexpr int kRounds = 2;
  const NoisyPoints::Band band = bandOf(parameters);
  FloorCandidate candidate;
  candidate.plane = hypothesis;
  Eigen::Vector3f normals;
  for (int round = 0; round < kRounds; ++round) {
    samples_.computeResiduals(candidate.plane, band);
    const Eigen::Vector3f normal = candidate.plane.normal.cast<float>();
    samples_.pick([&](std::size_t k) { return normals_[k].dot(normal) > kAgree; }, samples_.size(), picked_);
    PlaneFit fit;
    normals.setZero();
    for (const std::uint32_t k : picked_) {
      samples_.addTo(fit, k);
      normals += normals_[k];
    }
    const auto solution = fit.solve(prior.up);
    if (!solution) return;
    candidate.plane = solution->plane;
    candidate.ground_range = solution->plane.normal.cross(solution->centre).norm();
  }

  const geometry::Plane& plane = candidate.plane;
  candidate.tilt = angleBetween(plane.normal, prior.up);
  candidate.disagreement = angleBetween(plane.normal, normals.cast<double>());
  if (candidate.tilt > parameters.max_tilt + (prior.up_is_measured ? 0.0 : kSeedSlack)) return;
  if (plane.distance < parameters.min_camera_height) return;
  samples_.computeResiduals(plane, band);
  candidate.counts = samples_.counts();
  if (static_cast<double>(picked_.size()) < kLeastAgreeing * candidate.counts.inliers ||
      candidate.counts.inliers < kLeastSupport * static_cast<double>(segmentation_.segmentOf().size())) {
    return;
  }
  if (plane.distance > parameters.max_camera_height) {
    if (too_low_.size() < kMostCandidates) too_low_.push_back(candidate);
    return;
  }
  candidate.lowest = isLowest(plane, candidate.counts, parameters);
  candidate.continues = prior.height && std::abs(plane.distance - *prior.height) < prior.height_tolerance &&
                        (!prior.up_is_measured || candidate.tilt < (candidate.lowest ? kTurn : kTurnAtDrop));
  if (prior.height && !candidate.continues) {
    constexpr double kSameOffset = 0.1;  // [m]
    constexpr double kFarthestDrop =
        0.25;  // [m] that a camera sinks between frames; a nearer plane is a raised one
    const double offset = *prior.height - plane.distance;
    candidate.matches_other_plane = (prior.confirmed && offset > kFarthestDrop) ||
                                    std::any_of(prior.others.begin(), prior.others.end(), [&](double other) {
                                      return std::abs(offset - other) < kSameOffset + prior.height_tolerance;
                                    });
  }
  candidates_.push_back(candidate);
}

FloorCandidate* FloorCandidates::best(const FloorPrior& prior)
{
  return mostLikelyFloor(candidates_, prior, lowest_possible_);
}

PlaneOffsets FloorCandidates::others(const geometry::Plane& floor) const
{
  constexpr double kParallel = 0.17;        // [rad] 10 degrees
  constexpr double kLeastOffset = 0.15;     // [m]
  constexpr double kLeastOfSamples = 0.02;  // a smaller plane would not be taken for the floor for long
  PlaneOffsets offsets;
  for (const FloorCandidate& c : candidates_) {
    const double offset = floor.distance - c.plane.distance;
    if (std::abs(offset) > kLeastOffset && angleBetween(c.plane.normal, floor.normal) < kParallel &&
        c.counts.inliers > kLeastOfSamples * static_cast<double>(segmentation_.segmentOf().size())) {
      offsets.add(offset);
    }
  }
  return offsets;
}

std::uint32_t FloorCandidates::label(const std::optional<geometry::Plane>& floor,
                                     const FloorDetector::Parameters& parameters,
                                     std::vector<SampleLabel>& labels)
{
  std::uint32_t count = 0;
  labels.assign(segmentation_.segmentOf().size(), SampleLabel::kNoPoint);
  if (floor) samples_.computeResiduals(*floor, bandOf(parameters));
  for (std::size_t k = 0; k < samples_.size(); ++k) {
    const bool upright = !normals_[k].isZero();
    const bool on_floor = floor && upright && samples_.on(k);
    labels[sample_index_[k]] = on_floor  ? SampleLabel::kFloor
                               : upright ? SampleLabel::kSegment
                                         : SampleLabel::kPruned;
    count += on_floor ? 1 : 0;
  }
  return count;
}

}  // namespace polygonal_perception::perception

#include "polygonal_perception/floor_detector.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "noisy_points.hpp"
#include "plane_fit.hpp"
#include "segmentation.hpp"

namespace polygonal_perception {

namespace {

/// A sample's normal is noisy, so it may tilt this much more than the floor itself.
constexpr double kNormalSlack = 0.15;  // [rad]
/// A seed is a rough guess of the camera's attitude: a floor may tilt this much more from it than from a measured up.
constexpr double kSeedSlack = 0.15;  // [rad]
/// The floor's normal turns less than this between two frames of a camera that is moved by hand.
constexpr double kTurn = 0.26;  // [rad] 15 degrees

constexpr std::size_t kMostCandidates = 8;
constexpr std::uint32_t kSmallestSegment = 4;
/// The least share of all samples that must lie on a floor, and how many of those must have an upright normal.
constexpr double kLeastSupport = 0.006;
constexpr double kLeastUpright = 0.4;
/// A fit that leaves the normal more uncertain than this is no floor.
constexpr double kLargestNormalSigma = 0.02;  // [rad]

/// About how many pixels the final fit looks at, spread evenly over the image.
constexpr double kPixels = 4800.0;

double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

struct FloorDetector::Candidate
{
  Plane plane;
  NoisyPoints::Tally tally;
  double tilt = 0.0;      ///< [rad] from the up vector
  bool lowest = false;    ///< hardly a sample lies below it
  bool continues = false; ///< it is where the last floor was
};

struct FloorDetector::Workspace
{
  Segmentation segmentation;
  NoisyPoints samples;                      // those with a point
  std::vector<std::uint32_t> sample_index;  // their indices in the grid
  std::vector<std::uint8_t> upright;        // whether they belong to a segment
  NoisyPoints pixels;
  std::vector<std::uint32_t> by_size;
  std::vector<Candidate> candidates;
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
  Workspace& work = *workspace_;
  const double gate = parameters_.max_tilt + kNormalSlack + (prior.up_is_measured ? 0.0 : kSeedSlack);
  work.segmentation.segment(grid, prior.up.cast<float>(), static_cast<float>(std::cos(gate)),
                            static_cast<float>(parameters_.cluster_distance));
  work.samples.clear();
  work.sample_index.clear();
  work.upright.clear();
  for (std::uint32_t k = 0; k < grid.samples().size(); ++k) {
    if (!grid.samples()[k].has_point) continue;
    work.samples.add(grid.samples()[k].point);
    work.sample_index.push_back(k);
    work.upright.push_back(work.segmentation.segmentOf()[k] != Segmentation::kNone ? 1 : 0);
  }
  collectCandidates(grid, prior);

  std::optional<DetectedFloor> floor;
  if (!work.candidates.empty()) {
    const auto step = std::max(1U, static_cast<std::uint32_t>(std::sqrt(static_cast<double>(points.size()) / kPixels)));
    work.pixels.clear();
    for (std::uint32_t v = step / 2; v < points.height(); v += step) {
      for (std::uint32_t u = step / 2; u < points.width(); u += step) {
        const Eigen::Vector3f p = points.point(u, v);
        if (p.squaredNorm() < 1e6F) work.pixels.add(p);
      }
    }
  }
  while (!floor && !work.candidates.empty()) {
    const auto chosen = choose(prior);
    if (chosen == work.candidates.end()) break;
    floor = refine(*chosen, prior);
    work.candidates.erase(chosen);
  }
  label(grid, floor ? &*floor : nullptr);
  return floor;
}

void FloorDetector::collectCandidates(const SampleGrid& grid, const FloorPrior& prior)
{
  Workspace& work = *workspace_;
  work.candidates.clear();
  const auto& segments = work.segmentation.segments();
  const auto& members = work.segmentation.members();

  if (prior.height && prior.up_is_measured) {
    if (auto candidate = examine({prior.up, *prior.height}, prior)) work.candidates.push_back(*candidate);
  }
  work.by_size.clear();
  for (std::uint32_t s = 0; s < segments.size(); ++s) {
    if (segments[s].size >= kSmallestSegment) work.by_size.push_back(s);
  }
  std::sort(work.by_size.begin(), work.by_size.end(),
            [&](std::uint32_t a, std::uint32_t b) { return segments[a].size > segments[b].size; });
  for (const std::uint32_t s : work.by_size) {
    if (work.candidates.size() >= kMostCandidates) break;
    Eigen::Vector3d mean_point = Eigen::Vector3d::Zero();
    Eigen::Vector3d mean_normal = Eigen::Vector3d::Zero();
    for (std::uint32_t k = segments[s].first; k < segments[s].first + segments[s].size; ++k) {
      mean_point += grid.samples()[members[k]].point.cast<double>();
      mean_normal += grid.samples()[members[k]].normal.cast<double>();
    }
    mean_point /= segments[s].size;
    mean_normal.normalize();
    const Plane hypothesis{mean_normal, -mean_normal.dot(mean_point)};
    if (auto candidate = examine(hypothesis, prior)) work.candidates.push_back(*candidate);
  }
}

std::optional<FloorDetector::Candidate> FloorDetector::examine(const Plane& hypothesis, const FloorPrior& prior) const
{
  const Workspace& work = *workspace_;
  const auto widest = static_cast<float>(parameters_.merge_distance);
  const NoisyPoints::Band wide{0.03F, 3.0F, 0.01F, widest};
  const NoisyPoints::Band narrow{0.01F, 3.0F, 0.005F, widest};

  Plane plane = hypothesis;
  for (const NoisyPoints::Band& band : {wide, narrow}) {
    const auto fit = work.samples.fit(plane, band).solve(prior.up);
    if (!fit) return std::nullopt;
    plane = fit->plane;
  }

  Candidate candidate;
  candidate.plane = plane;
  candidate.tilt = angleBetween(plane.normal, prior.up);
  if (candidate.tilt > parameters_.max_tilt + (prior.up_is_measured ? 0.0 : kSeedSlack)) return std::nullopt;
  if (plane.distance < parameters_.min_camera_height || plane.distance > parameters_.max_camera_height) {
    return std::nullopt;
  }
  candidate.tally = work.samples.tally(plane, narrow);
  int upright = 0;
  for (std::size_t k = 0; k < work.samples.size(); ++k) {
    upright += work.upright[k] != 0 && work.samples.on(k, plane, narrow) ? 1 : 0;
  }
  if (upright < kLeastUpright * candidate.tally.on) return std::nullopt;
  if (candidate.tally.on < kLeastSupport * static_cast<double>(work.segmentation.segmentOf().size())) {
    return std::nullopt;
  }
  candidate.lowest = candidate.tally.below * parameters_.replacement_factor <= candidate.tally.on;
  candidate.continues = prior.height && std::abs(plane.distance - *prior.height) < prior.height_tolerance &&
                        (!prior.up_is_measured || candidate.tilt < kTurn);
  return candidate;
}

std::vector<FloorDetector::Candidate>::const_iterator FloorDetector::choose(const FloorPrior& prior) const
{
  constexpr double kParallel = 0.17;     // [rad] 10 degrees
  constexpr double kTiltScale = 0.45;    // [rad] a tilt from the up vector at which a plane loses most of its weight
  const auto& candidates = workspace_->candidates;
  const auto weight = [&](const Candidate& c) {
    const double tilt = c.tilt / kTiltScale;
    return c.tally.on * std::exp(-tilt * tilt);
  };
  auto best = candidates.end();
  for (auto c = candidates.begin(); c != candidates.end(); ++c) {
    if (prior.firm ? !c->continues : !c->lowest) continue;
    if (best == candidates.end()) {
      best = c;
    } else if (angleBetween(c->plane.normal, best->plane.normal) < kParallel && !prior.firm) {
      if (c->plane.distance > best->plane.distance) best = c;
    } else if (weight(*c) > weight(*best)) {
      best = c;
    }
  }
  return best;
}

std::optional<DetectedFloor> FloorDetector::refine(const Candidate& candidate, const FloorPrior& prior) const
{
  const NoisyPoints& pixels = workspace_->pixels;
  const auto widest = static_cast<float>(parameters_.merge_distance);
  const NoisyPoints::Band wide{0.01F, 3.0F, 0.005F, widest};
  const NoisyPoints::Band narrow{0.006F, 2.5F, 0.003F, widest};

  std::optional<PlaneFit::Result> fit;
  Plane plane = candidate.plane;
  for (const NoisyPoints::Band& band : {wide, narrow, narrow}) {
    fit = pixels.fit(plane, band).solve(prior.up);
    if (!fit) return std::nullopt;
    plane = fit->plane;
  }
  const NoisyPoints::Tally tally = pixels.tally(plane, wide);
  if (fit->normal_sigma > kLargestNormalSigma || tally.on < kLeastSupport * kPixels) return std::nullopt;
  const bool lowest = tally.below * parameters_.replacement_factor <= tally.on;
  if (!lowest && !(prior.firm && candidate.continues)) return std::nullopt;

  DetectedFloor floor;
  floor.plane = plane;
  floor.rms_error = fit->rms_error;
  floor.drop_in_view = !lowest;
  floor.continued = candidate.continues;
  return floor;
}

void FloorDetector::label(const SampleGrid& grid, DetectedFloor* floor)
{
  const Workspace& work = *workspace_;
  const NoisyPoints::Band band{0.01F, 3.0F, 0.005F, static_cast<float>(parameters_.merge_distance)};
  labels_.assign(grid.samples().size(), SampleLabel::kNoPoint);
  for (std::size_t k = 0; k < work.samples.size(); ++k) {
    SampleLabel& label = labels_[work.sample_index[k]];
    label = work.upright[k] != 0 ? SampleLabel::kSegment : SampleLabel::kPruned;
    if (floor == nullptr || work.upright[k] == 0 || !work.samples.on(k, floor->plane, band)) continue;
    label = SampleLabel::kFloor;
    ++floor->sample_count;
  }
}

}  // namespace polygonal_perception

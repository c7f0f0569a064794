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
/// A seed is a rough guess of the camera's attitude: a floor may tilt this much more from it than from a
/// measured up.
constexpr double kSeedSlack = 0.15;  // [rad]
/// The floor's normal turns less than this between two frames of a camera that is moved by hand.
constexpr double kTurn = 0.26;  // [rad] 15 degrees

/// What is not the lowest plane of the frame must look more like the last floor to be taken for it.
constexpr double kTurnAtDrop = 0.08;  // [rad]

/// A plane this near to where another one stood above or below the floor is that other one.
constexpr double kSameOffset = 0.1;  // [m]

constexpr std::size_t kMostCandidates = 8;
constexpr std::uint32_t kSmallestSegment = 4;
/// The least share of all samples that must lie on a floor, and how many of those must have an upright
/// normal.
constexpr double kLeastSupport = 0.006;
constexpr double kLeastUpright = 0.4;
/// Cosine of the largest angle between a plane's normal and that of a sample that belongs to it: 26 degrees,
/// two and a half times the noise of a sample's normal 4 m away.
constexpr float kAgree = 0.9F;
/// A fit that leaves the normal more uncertain than this is no floor.
constexpr double kLargestNormalSigma = 0.02;  // [rad]

/// About how many pixels the final fit looks at, spread evenly over the image: rows lie closer than columns,
/// because a floor that is seen from the side is a narrow strip at the image's foot.
constexpr std::uint32_t kPixelColumns = 53;
constexpr std::uint32_t kPixelRows = 96;

double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// A fit through this many pixels errs by less than the camera's own calibration.
constexpr std::size_t kEnoughPixels = 700;

/// Whether the surface at pixel k runs along the plane rather than across it, as the foot of a wall does,
/// which lies in the plane's band but would tilt the fit.
bool liesFlat(const NoisyPoints& pixels, std::size_t k, std::size_t columns)
{
  return (k < columns || pixels.runsAlong(k, k - columns)) &&
         (k + columns >= pixels.size() || pixels.runsAlong(k, k + columns));
}

}  // namespace

struct FloorDetector::Candidate
{
  Plane plane;
  NoisyPoints::Tally tally;
  double tilt = 0.0;         ///< [rad] from the up vector
  bool lowest = false;       ///< hardly a sample lies below it
  bool continues = false;    ///< it is where the last floor was
  bool known_other = false;  ///< it is where another plane was seen with the last floor
  bool refused = false;      ///< a closer look found that it is no floor
};

struct FloorDetector::Workspace
{
  Segmentation segmentation;
  NoisyPoints samples;                      // those with a point
  std::vector<std::uint32_t> sample_index;  // their indices in the grid
  std::vector<std::uint8_t> upright;        // whether they belong to a segment
  std::vector<Eigen::Vector3f> normals;     // theirs, where upright
  NoisyPoints pixels;                       // a regular grid of them, NaN where there is no return
  std::size_t pixel_columns = 0;
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
  work.normals.clear();
  for (std::uint32_t k = 0; k < grid.samples().size(); ++k) {
    if (!grid.samples()[k].has_point) continue;
    work.samples.add(grid.samples()[k].point);
    work.sample_index.push_back(k);
    work.normals.push_back(grid.samples()[k].normal);
    work.upright.push_back(work.segmentation.segmentOf()[k] != Segmentation::kNone ? 1 : 0);
  }
  collectCandidates(grid, prior);

  std::optional<DetectedFloor> floor;
  if (!work.candidates.empty()) {
    takePixels(points);
  }
  for (auto* chosen = choose(prior); chosen != nullptr && !floor; chosen = choose(prior)) {
    floor = refine(*chosen, prior);
    chosen->refused = true;
  }
  if (floor) noteOtherPlanes(*floor);
  label(grid, floor ? &*floor : nullptr);
  return floor;
}

void FloorDetector::takePixels(const PointView& points)
{
  Workspace& work = *workspace_;
  const auto step_u = std::max(1U, points.width() / kPixelColumns);
  const auto step_v = std::max(1U, points.height() / kPixelRows);
  work.pixels.clear();
  work.pixel_columns = 0;
  for (std::uint32_t v = step_v / 2; v < points.height(); v += step_v) {
    for (std::uint32_t u = step_u / 2; u < points.width(); u += step_u) work.pixels.add(points.point(u, v));
    if (work.pixel_columns == 0) work.pixel_columns = work.pixels.size();
  }
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

std::optional<FloorDetector::Candidate> FloorDetector::examine(const Plane& hypothesis,
                                                               const FloorPrior& prior)
{
  Workspace& work = *workspace_;
  const auto widest = static_cast<float>(parameters_.merge_distance);
  const NoisyPoints::Band wide{0.03F, 3.0F, 0.01F, widest};
  const NoisyPoints::Band narrow{0.01F, 3.0F, 0.005F, widest};

  Candidate candidate;
  candidate.plane = hypothesis;
  int agreeing = 0;
  for (const NoisyPoints::Band& band : {wide, narrow}) {
    work.samples.compare(candidate.plane, band);
    const Eigen::Vector3f normal = candidate.plane.normal.cast<float>();
    const PlaneFit fit = work.samples.fit(
        [&](std::size_t k) { return work.upright[k] != 0 && work.normals[k].dot(normal) > kAgree; },
        work.samples.size());
    agreeing = static_cast<int>(fit.count());
    const auto solution = fit.solve(prior.up);
    if (!solution) return std::nullopt;
    candidate.plane = solution->plane;
  }

  const Plane& plane = candidate.plane;
  candidate.tilt = angleBetween(plane.normal, prior.up);
  if (candidate.tilt > parameters_.max_tilt + (prior.up_is_measured ? 0.0 : kSeedSlack)) return std::nullopt;
  if (plane.distance < parameters_.min_camera_height || plane.distance > parameters_.max_camera_height) {
    return std::nullopt;
  }
  work.samples.compare(plane, narrow);
  candidate.tally = work.samples.tally();
  if (agreeing < kLeastUpright * candidate.tally.on) return std::nullopt;
  if (candidate.tally.on < kLeastSupport * static_cast<double>(work.segmentation.segmentOf().size())) {
    return std::nullopt;
  }
  candidate.lowest = candidate.tally.below * parameters_.replacement_factor <= candidate.tally.on;
  candidate.continues = prior.height && std::abs(plane.distance - *prior.height) < prior.height_tolerance &&
                        (!prior.up_is_measured || candidate.tilt < (candidate.lowest ? kTurn : kTurnAtDrop));
  if (prior.height && !candidate.continues) {
    const double offset = *prior.height - plane.distance;
    candidate.known_other = std::any_of(prior.others.begin(), prior.others.end(), [&](double other) {
      return std::abs(offset - other) < kSameOffset + prior.height_tolerance;
    });
  }
  return candidate;
}

FloorDetector::Candidate* FloorDetector::choose(const FloorPrior& prior)
{
  constexpr double kTiltScale =
      0.45;  // [rad] a tilt from the up vector at which a plane loses most of its weight
  constexpr double kMostOf = 0.6;
  const auto weight = [&](const Candidate& c) {
    const double tilt = c.tilt / kTiltScale;
    return c.tally.on * std::exp(-tilt * tilt);
  };
  // A plane is under another one when what lies on it lies below the other. Heights alone would not tell: a
  // steep fit through the foot of a wall cuts through the floor and passes far below the camera.
  const auto under = [&](const Candidate& lower, const Candidate& upper) {
    return lower.plane.distance > upper.plane.distance && upper.tally.below > kMostOf * lower.tally.on;
  };
  Candidate* best = nullptr;
  for (Candidate& c : workspace_->candidates) {
    const bool own = prior.firm && c.continues;
    if (c.refused || c.known_other || !(own || c.lowest)) continue;
    const bool best_is_own = best != nullptr && prior.firm && best->continues;
    if (best == nullptr || own != best_is_own) {
      if (best == nullptr || own) best = &c;
    } else if ((!own && under(c, *best)) || (weight(c) > weight(*best) && (own || !under(*best, c)))) {
      best = &c;
    }
  }
  return best;
}

void FloorDetector::noteOtherPlanes(DetectedFloor& floor) const
{
  constexpr double kParallel = 0.17;        // [rad] 10 degrees
  constexpr double kLeastOffset = 0.15;     // [m]
  constexpr double kLeastOfSamples = 0.02;  // a smaller plane would not be taken for the floor for long
  for (const Candidate& c : workspace_->candidates) {
    const double offset = floor.plane.distance - c.plane.distance;
    if (std::abs(offset) > kLeastOffset && angleBetween(c.plane.normal, floor.plane.normal) < kParallel &&
        c.tally.on > kLeastOfSamples * static_cast<double>(workspace_->segmentation.segmentOf().size())) {
      floor.others.add(offset);
    }
  }
}

std::optional<DetectedFloor> FloorDetector::refine(const Candidate& candidate, const FloorPrior& prior)
{
  Workspace& work = *workspace_;
  NoisyPoints& pixels = work.pixels;
  const auto widest = static_cast<float>(parameters_.merge_distance);
  const NoisyPoints::Band wide{0.01F, 3.0F, 0.005F, widest};
  const NoisyPoints::Band narrow{0.006F, 2.5F, 0.008F, widest};

  std::optional<PlaneFit::Result> fit;
  Plane plane = candidate.plane;
  for (const NoisyPoints::Band& band : {wide, narrow, narrow}) {
    pixels.compare(plane, band);
    fit = pixels.fit([&](std::size_t k) { return liesFlat(pixels, k, work.pixel_columns); }, kEnoughPixels)
              .solve(prior.up);
    if (!fit) return std::nullopt;
    plane = fit->plane;
  }
  pixels.compare(plane, wide);
  const NoisyPoints::Tally tally = pixels.tally();
  if (fit->normal_sigma > kLargestNormalSigma ||
      tally.on < kLeastSupport * static_cast<double>(pixels.size())) {
    return std::nullopt;
  }
  const bool lowest = tally.below * parameters_.replacement_factor <= tally.on;
  if (!lowest && !(prior.firm && candidate.continues)) return std::nullopt;

  DetectedFloor floor;
  floor.plane = plane;
  floor.rms_error = fit->rms_error;
  floor.continued = candidate.continues;
  return floor;
}

void FloorDetector::label(const SampleGrid& grid, DetectedFloor* floor)
{
  Workspace& work = *workspace_;
  const NoisyPoints::Band band{0.01F, 3.0F, 0.005F, static_cast<float>(parameters_.merge_distance)};
  labels_.assign(grid.samples().size(), SampleLabel::kNoPoint);
  if (floor != nullptr) work.samples.compare(floor->plane, band);
  for (std::size_t k = 0; k < work.samples.size(); ++k) {
    SampleLabel& label = labels_[work.sample_index[k]];
    label = work.upright[k] != 0 ? SampleLabel::kSegment : SampleLabel::kPruned;
    if (floor == nullptr || work.upright[k] == 0 || !work.samples.on(k)) continue;
    label = SampleLabel::kFloor;
    ++floor->sample_count;
  }
}

}  // namespace polygonal_perception

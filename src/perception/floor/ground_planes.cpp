#include "polygonal_perception/perception/floor/ground_planes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "perception/planes/plane_extraction.hpp"
#include "polygonal_perception/geometry/angle.hpp"

namespace polygonal_perception::perception {

namespace {

/// [m] How high the step between two planes is, by the height of a sample of each above the other: 0 where both samples
/// lie on the same side, for there the planes meet between them.
float stepHeight(float first, float second)
{
  return (first < 0.0F) != (second < 0.0F) ? std::min(std::abs(first), std::abs(second)) : 0.0F;
}

}  // namespace

struct GroundPlanes::Workspace
{
  /// What the pairs of samples on both sides of a border say.
  struct Border
  {
    double pairs = 0.0;
    double step = 0.0;  // [m] sum over the pairs

    bool meets(const GroundPlanes::Parameters& parameters) const
    {
      return pairs >= parameters.least_pairs && step < parameters.least_step * pairs;
    }
  };

  std::vector<ReferencePlane> references;  // of each plane of the frame
  std::vector<Border> borders;             // of each two of them
  std::vector<std::uint8_t> is_ground;     // of each
  std::vector<std::size_t> of_floor;       // of each, how many samples are the floor's
  std::vector<std::size_t> open;           // ground whose neighbours have not been looked at
  std::vector<GroundPlane> ground;
  std::vector<GroundPlane> spare;  // of earlier frames, for their memory

  void compareBorders(const PlaneExtraction& extraction, const Parameters& parameters);
  void comparePair(const PlaneExtraction& extraction, std::uint32_t from, std::uint32_t to,
                   const Parameters& parameters);
  GroundPlane& add(const geometry::Plane& plane);
  void take(const PlaneExtraction& extraction, std::size_t index);
  void seedAhead(const PlaneExtraction& extraction, const geometry::Plane& floor,
                 const Parameters& parameters);
};

GroundPlanes::GroundPlanes(const Parameters& parameters)
    : parameters_(parameters), workspace_(std::make_unique<Workspace>())
{
}
GroundPlanes::GroundPlanes(GroundPlanes&& other) noexcept = default;
GroundPlanes& GroundPlanes::operator=(GroundPlanes&& other) noexcept = default;
GroundPlanes::~GroundPlanes() = default;

const std::vector<GroundPlane>& GroundPlanes::find(const FloorDetector& detector,
                                                   const geometry::Plane& floor)
{
  Workspace& w = *workspace_;
  const PlaneExtraction& extraction = detector.extraction();
  const std::size_t count = extraction.planes().size();
  for (; !w.ground.empty(); w.ground.pop_back()) w.spare.push_back(std::move(w.ground.back()));
  w.add(floor);
  w.is_ground.assign(count, 0);
  w.open.clear();
  w.compareBorders(extraction, parameters_);

  // The floor's own samples, in whichever of the frame's planes they are.
  w.of_floor.assign(count, 0);
  for (std::uint32_t k = 0; k < extraction.samples().size(); ++k) {
    if (detector.labels()[k] != SampleLabel::kFloor) continue;
    w.ground.front().samples.push_back(extraction.samples()[k].point);
    if (extraction.planeOf()[k] != PlaneSegments::kNone)
      ++w.of_floor[static_cast<std::size_t>(extraction.planeOf()[k])];
  }
  for (std::size_t k = 0; k < count; ++k) {
    if (2 * w.of_floor[k] <= extraction.planes()[k].size) continue;
    w.is_ground[k] = 1;
    w.open.push_back(k);
  }

  if (w.open.empty()) w.seedAhead(extraction, floor, parameters_);

  while (!w.open.empty()) {
    const std::size_t here = w.open.back();
    w.open.pop_back();
    for (std::size_t there = 0; there < count; ++there) {
      const Workspace::Border& border = w.borders[here * count + there];
      if (w.is_ground[there] != 0 || !border.meets(parameters_)) continue;
      const geometry::Plane& plane = extraction.planes()[there].fit.plane;
      if (geometry::angleBetween(plane.normal, floor.normal) > parameters_.max_slope) continue;
      w.is_ground[there] = 1;
      w.open.push_back(there);
      w.take(extraction, there);
    }
  }
  return w.ground;
}

/// Where nothing of the floor is seen: the nearest plane, if it meets the floor on the way to it.
void GroundPlanes::Workspace::seedAhead(const PlaneExtraction& extraction, const geometry::Plane& floor,
                                        const Parameters& parameters)
{
  std::optional<std::uint32_t> nearest;
  double distance = 0.0;
  for (std::uint32_t k = 0; k < extraction.samples().size(); ++k) {
    if (extraction.planeOf()[k] == PlaneSegments::kNone) continue;
    const double there = floor.normal.cross(extraction.samples()[k].point.cast<double>()).norm();
    if (nearest && there >= distance) continue;
    nearest = k;
    distance = there;
  }
  if (!nearest) return;
  const auto index = static_cast<std::size_t>(extraction.planeOf()[*nearest]);
  const geometry::Plane& plane = extraction.planes()[index].fit.plane;
  const Eigen::Vector3d foot = -floor.distance * floor.normal;
  const double at_foot = -plane.height(foot);
  const double at_sample = floor.height(extraction.samples()[*nearest].point.cast<double>());
  const bool meets = std::abs(at_foot) < parameters.meeting_height ||
                     std::abs(at_sample) < parameters.meeting_height || (at_foot < 0.0) != (at_sample < 0.0);
  if (!meets || geometry::angleBetween(plane.normal, floor.normal) > parameters.max_slope) return;
  is_ground[index] = 1;
  open.push_back(index);
  take(extraction, index);
}

/// Without samples yet.
GroundPlane& GroundPlanes::Workspace::add(const geometry::Plane& plane)
{
  if (spare.empty()) spare.emplace_back();
  ground.push_back(std::move(spare.back()));
  spare.pop_back();
  ground.back().plane = plane;
  ground.back().samples.clear();
  return ground.back();
}

void GroundPlanes::Workspace::take(const PlaneExtraction& extraction, std::size_t index)
{
  const ExtractedPlane& plane = extraction.planes()[index];
  GroundPlane& more = add(plane.fit.plane);
  extraction.forEachMember(plane, [&](const NoisySample& sample) { more.samples.push_back(sample.point); });
}

/// Looks at the nearest samples of two planes to the right of each other and below: those right at the hinge often belong to
/// neither.
void GroundPlanes::Workspace::compareBorders(const PlaneExtraction& extraction, const Parameters& parameters)
{
  constexpr std::uint32_t kReach = 3;
  references.clear();
  for (const ExtractedPlane& plane : extraction.planes()) references.emplace_back(plane.fit.plane);
  borders.assign(references.size() * references.size(), Border{});
  const NoisySamples& samples = extraction.samples();
  for (std::uint32_t k = 0; k < samples.size(); ++k) {
    if (extraction.planeOf()[k] == PlaneSegments::kNone) continue;
    const std::uint32_t left_in_row = samples.columns - 1 - k % samples.columns;
    for (std::uint32_t step = 1; step <= std::min(kReach, left_in_row); ++step) {
      if (extraction.planeOf()[k + step] == PlaneSegments::kNone) continue;
      comparePair(extraction, k, k + step, parameters);
      break;
    }
    for (std::uint32_t step = 1; step <= kReach && k + step * samples.columns < samples.size(); ++step) {
      if (extraction.planeOf()[k + step * samples.columns] == PlaneSegments::kNone) continue;
      comparePair(extraction, k, k + step * samples.columns, parameters);
      break;
    }
  }
}

void GroundPlanes::Workspace::comparePair(const PlaneExtraction& extraction, std::uint32_t from,
                                          std::uint32_t to, const Parameters& parameters)
{
  const auto a = static_cast<std::size_t>(extraction.planeOf()[from]);
  const auto b = static_cast<std::size_t>(extraction.planeOf()[to]);
  if (a == b) return;
  const NoisySample& on_a = extraction.samples()[from];
  const NoisySample& on_b = extraction.samples()[to];
  const float nearer = std::min(on_a.range, on_b.range);
  if ((on_a.point - on_b.point).norm() > static_cast<float>(parameters.nearest_pair) * nearer) return;
  const float step = stepHeight(references[b].height(on_a.point), references[a].height(on_b.point));
  for (Border* const border : {&borders[a * references.size() + b], &borders[b * references.size() + a]}) {
    border->pairs += 1.0;
    border->step += step;
  }
}

}  // namespace polygonal_perception::perception

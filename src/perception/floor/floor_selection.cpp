#include "perception/floor/floor_selection.hpp"

#include <algorithm>
#include <cmath>

#include "perception/floor/stair_steps.hpp"
#include "polygonal_perception/geometry/angle.hpp"

namespace polygonal_perception::perception {

namespace {

/// [m] Along a plane from under the camera to where its samples begin: a tenth of them may be nearer.
double beginOf(const PlaneExtraction& extraction, const ExtractedPlane& plane, std::vector<double>& distances)
{
  const Eigen::Vector3f normal = plane.fit.plane.normal.cast<float>();
  distances.clear();
  extraction.forEachMember(plane, [&](const NoisySample& sample) {
    const float along = normal.dot(sample.point);
    distances.push_back(std::max(0.0F, sample.range * sample.range - along * along));
  });
  const auto tenth = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 10);
  std::nth_element(distances.begin(), tenth, distances.end());
  return std::sqrt(*tenth);
}

/// Samples below a candidate that are of no plane parallel to it, and not deeper than a floor can be.
double scatterBelow(const PlaneExtraction& extraction, const FloorCandidate& candidate,
                    const FloorSelectionParameters& parameters, double highest,
                    const std::vector<std::uint8_t>& is_parallel)
{
  const Eigen::Vector3f normal = candidate.fit.plane.normal.cast<float>();
  const auto distance = static_cast<float>(candidate.fit.plane.distance);
  const auto base = static_cast<float>(parameters.scatter_depth);
  const auto slope = static_cast<float>(parameters.scatter_depth_slope);
  const auto deepest = static_cast<float>(highest);
  int below = 0;
  for (std::uint32_t k = 0; k < extraction.samples().size(); ++k) {
    const NoisySample& sample = extraction.samples()[k];
    const int plane = extraction.planeOf()[k];
    if (!sample.has_point ||
        (plane != PlaneSegments::kNone && is_parallel[static_cast<std::size_t>(plane)] != 0))
      continue;
    const float along = normal.dot(sample.point);
    below += along + distance < -(base + slope * sample.range) && -along < deepest ? 1 : 0;
  }
  return below;
}

/// How many samples of a plane lie clearly below another one.
double countBelow(const PlaneExtraction& extraction, const ExtractedPlane& lower,
                  const geometry::Plane& upper, const FloorSelectionParameters& parameters)
{
  const ReferencePlane reference(upper);
  const auto squared_sigmas = static_cast<float>(parameters.clearly_below * parameters.clearly_below);
  int below = 0;
  extraction.forEachMember(lower, [&](const NoisySample& sample) {
    below += reference.height(sample.point) < 0.0F && reference.deviation(sample) > squared_sigmas ? 1 : 0;
  });
  return below;
}

void compareWithLast(FloorCandidate& candidate, const FloorSelectionParameters& parameters,
                     const FloorPrior& prior)
{
  if (!prior.height) return;
  const double offset = *prior.height - candidate.fit.plane.distance;
  candidate.continues = std::abs(offset) < prior.height_tolerance &&
                        (!prior.last || geometry::angleBetween(candidate.fit.plane.normal,
                                                               prior.last->normal) < parameters.turn);
  candidate.is_other_plane =
      !candidate.continues &&
      ((prior.confirmed && offset > parameters.farthest_drop) ||
       std::any_of(prior.others.begin(), prior.others.end(), [&](double other) {
         return std::abs(offset - other) < parameters.same_offset + prior.height_tolerance;
       }));
}

double scoreOf(const FloorCandidate& candidate, const FloorSelectionParameters& p, const FloorPrior& prior)
{
  const double about = prior.up_is_measured ? p.tilt_about_measured : p.tilt_about_seed;
  const double tilt = candidate.tilt / prior.tilt_sigma.value_or(about);
  const double size = candidate.size;
  double score = std::log(size);
  score -= 0.5 * tilt * tilt;
  score -= p.scatter * std::log(1.0 + candidate.scatter / (p.scatter_share * size));
  score -= p.distance * std::log(std::max(0.1, candidate.begin));
  if (candidate.continues && prior.confirmed) score += p.confirmed;
  if (candidate.is_other_plane) score -= p.other_plane;
  if (candidate.is_step) score -= p.step;
  return score;
}

}  // namespace

bool contradictsTf(const geometry::Plane& plane, const FloorSelectionParameters& parameters,
                   const FloorPrior& prior)
{
  return prior.level && geometry::angleBetween(plane.normal, *prior.level) > parameters.farthest_from_level;
}

void FloorSelection::rate(const PlaneExtraction& extraction, const FloorSelectionParameters& parameters,
                          const FloorPrior& prior)
{
  collect(extraction, parameters, prior);
  compare(extraction, parameters);
  markStairSteps(candidates_, parameters);
  for (FloorCandidate& candidate : candidates_) candidate.score = scoreOf(candidate, parameters, prior);
}

void FloorSelection::collect(const PlaneExtraction& extraction, const FloorSelectionParameters& parameters,
                             const FloorPrior& prior)
{
  const double max_tilt = prior.maxTiltWith(parameters);
  bounds_ = prior.boundsWith(parameters);
  samples_ = extraction.samples().size();
  candidates_.clear();
  candidate_of_.assign(extraction.planes().size(), -1);
  for (std::size_t index = 0; index < extraction.planes().size(); ++index) {
    const ExtractedPlane& plane = extraction.planes()[index];
    FloorCandidate candidate;
    candidate.fit = plane.fit;
    candidate.size = plane.size;
    candidate.index = static_cast<int>(index);
    candidate.tilt = geometry::angleBetween(plane.fit.plane.normal, prior.up);
    candidate.too_low = plane.fit.plane.distance > bounds_.highest;
    if (candidate.tilt > max_tilt || plane.fit.plane.distance < bounds_.lowest) continue;
    if (contradictsTf(plane.fit.plane, parameters, prior)) continue;
    candidate.begin = beginOf(extraction, plane, distances_);
    candidate.middle = plane.fit.plane.normal.cross(plane.fit.centre).norm();
    compareWithLast(candidate, parameters, prior);
    candidate_of_[index] = static_cast<int>(candidates_.size());
    candidates_.push_back(candidate);
  }
}

void FloorSelection::compare(const PlaneExtraction& extraction, const FloorSelectionParameters& parameters)
{
  const std::size_t count = candidates_.size();
  below_.assign(count * count, 0.0);
  for (std::size_t a = 0; a < count; ++a) {
    FloorCandidate& upper = candidates_[a];
    is_parallel_.assign(extraction.planes().size(), 0);
    for (std::size_t b = 0; b < count; ++b) {
      const FloorCandidate& lower = candidates_[b];
      if (geometry::angleBetween(upper.fit.plane.normal, lower.fit.plane.normal) > parameters.parallel)
        continue;
      is_parallel_[static_cast<std::size_t>(lower.index)] = 1;
      if (a == b || lower.too_low) continue;
      below_[a * count + b] =
          countBelow(extraction, extraction.planes()[static_cast<std::size_t>(lower.index)], upper.fit.plane,
                     parameters);
    }
    upper.scatter = scatterBelow(extraction, upper, parameters, bounds_.highest, is_parallel_);
  }
}

double FloorSelection::evidence(std::size_t from, std::size_t to,
                                const FloorSelectionParameters& parameters) const
{
  const std::size_t count = candidates_.size();
  const FloorCandidate& here = candidates_[from];
  const FloorCandidate& there = candidates_[to];
  double evidence = 0.0;
  const double below = below_[from * count + to];
  if (below > below_[to * count + from])
    evidence += parameters.lower_plane_weight * std::log(1.0 + below / parameters.lower_plane_unit);
  if (there.middle < here.middle && there.fit.plane.height(here.fit.centre) > 0.0) {
    evidence += parameters.nearer;
  }
  return evidence;
}

FloorCandidate* FloorSelection::best(const FloorSelectionParameters& parameters)
{
  const auto may_be = [&](const FloorCandidate& candidate) {
    return !candidate.refused && !candidate.too_low && candidate.score >= parameters.least_score;
  };
  FloorCandidate* best = nullptr;
  for (FloorCandidate& candidate : candidates_) {
    if (may_be(candidate) && (best == nullptr || candidate.score > best->score)) best = &candidate;
  }
  // Each step leads to another plane, and a chain of more steps than planes would go in circles.
  for (std::size_t step = 0; best != nullptr && step < candidates_.size(); ++step) {
    const auto here = static_cast<std::size_t>(best - candidates_.data());
    double most = 0.0;
    for (std::size_t there = 0; there < candidates_.size(); ++there) {
      if (there == here || !may_be(candidates_[there])) continue;
      const double seen = evidence(here, there, parameters);
      const double gain = candidates_[there].score + seen - candidates_[here].score;
      if (seen <= 0.0 || gain <= most) continue;
      most = gain;
      best = &candidates_[there];
    }
    if (most == 0.0) break;
  }
  return best;
}

PlaneOffsets FloorSelection::others(const geometry::Plane& floor,
                                    const FloorSelectionParameters& parameters) const
{
  PlaneOffsets offsets;
  const double least = parameters.least_share * static_cast<double>(samples_);
  for (const FloorCandidate& other : candidates_) {
    const double offset = floor.distance - other.fit.plane.distance;
    if (std::abs(offset) > parameters.least_offset && other.size > least && !other.too_low &&
        geometry::angleBetween(other.fit.plane.normal, floor.normal) < parameters.other_angle) {
      offsets.add(offset);
    }
  }
  return offsets;
}

}  // namespace polygonal_perception::perception

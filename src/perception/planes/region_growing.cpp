#include "perception/planes/region_growing.hpp"

#include <algorithm>
#include <array>

namespace polygonal_perception::perception {

namespace {

/// Cosines between a sample's normal and the worst of its neighbours': 3.6, 8 and 26 degrees. The least rank has
/// all others.
constexpr std::array<float, 3> kFlatness = {0.998F, 0.99F, 0.9F};

/// The plane that grows.
struct Growth
{
  ReferencePlane plane;
  bool is_fitted = false;  // to enough samples to hold others against it

  bool accepts(const NoisySample& sample, const PlaneExtractionParameters& parameters) const
  {
    if (!(sample.normal.dot(plane.normal) > static_cast<float>(parameters.normal_cosine))) return false;
    if (!is_fitted) return true;
    const auto sigmas = static_cast<float>(parameters.growing_sigmas);
    return plane.deviation(sample, static_cast<float>(parameters.fitting_model_share)) < sigmas * sigmas;
  }
};

}  // namespace

void RegionGrowing::grow(const NoisySamples& samples, const PlaneExtractionParameters& parameters,
                         PlaneSegments& segments)
{
  segments.all.clear();
  segments.of_sample.assign(samples.size(), PlaneSegments::kNone);
  sortByFlatness(samples);
  for (const std::uint32_t seed : seeds_) {
    if (segments.of_sample[seed] == PlaneSegments::kNone) flood(seed, samples, parameters, segments);
  }
}

void RegionGrowing::sortByFlatness(const NoisySamples& samples)
{
  least_cosine_.assign(samples.size(), 1.0F);
  samples.forEachPair([&](std::uint32_t k, std::uint32_t neighbour) {
    const NoisySample& a = samples[k];
    const NoisySample& b = samples[neighbour];
    const float cosine = a.has_normal && b.has_normal ? a.normal.dot(b.normal) : 0.0F;
    least_cosine_[k] = std::min(least_cosine_[k], cosine);
    least_cosine_[neighbour] = std::min(least_cosine_[neighbour], cosine);
  });
  const auto rankOf = [&](std::uint32_t k) {
    std::size_t rank = 0;
    for (const float flatness : kFlatness) rank += least_cosine_[k] <= flatness ? 1 : 0;
    return rank;
  };
  // A counting sort; in a rank the samples stay in their order.
  std::array<std::uint32_t, kFlatness.size() + 2> begin{};
  for (std::uint32_t k = 0; k < samples.size(); ++k) begin[rankOf(k) + 1] += samples[k].has_normal ? 1 : 0;
  for (std::size_t rank = 1; rank < begin.size(); ++rank) begin[rank] += begin[rank - 1];
  seeds_.resize(begin.back());
  for (std::uint32_t k = 0; k < samples.size(); ++k) {
    if (samples[k].has_normal) seeds_[begin[rankOf(k)]++] = k;
  }
}

void RegionGrowing::flood(std::uint32_t seed, const NoisySamples& samples,
                          const PlaneExtractionParameters& parameters, PlaneSegments& segments)
{
  const int id = static_cast<int>(segments.all.size());
  PlaneSegment segment;
  Growth growth{ReferencePlane(samples[seed].normal, -samples[seed].normal.dot(samples[seed].point))};
  auto next_fit = static_cast<std::size_t>(parameters.least_samples);
  const auto join = [&](std::uint32_t k) {
    segments.of_sample[k] = id;
    members_.push_back(k);
    segment.add(samples[k], growth.plane.normal);
  };
  members_.clear();
  join(seed);
  // The members themselves are the queue of samples whose neighbours are still to be looked at.
  for (std::size_t next = 0; next < members_.size(); ++next) {
    const std::uint32_t here = members_[next];
    samples.forEachNeighbour(here, [&](std::uint32_t there) {
      if (segments.of_sample[there] != PlaneSegments::kNone || !samples[there].has_normal) return;
      if (!growth.accepts(samples[there], parameters) || !samples.areOnOneSurface(here, there, parameters))
        return;
      join(there);
      if (members_.size() < next_fit) return;
      next_fit = 2 * members_.size();
      const auto fit = segment.points.solve(growth.plane.normal.cast<double>());
      if (fit) growth = {ReferencePlane(fit->plane), true};
    });
  }
  if (segment.refit(growth.plane.normal.cast<double>(), parameters)) {
    segments.all.push_back(segment);
  } else {
    for (const std::uint32_t k : members_) segments.of_sample[k] = PlaneSegments::kNone;
  }
}

}  // namespace polygonal_perception::perception

#include "perception/planes/plane_extraction.hpp"

namespace polygonal_perception::perception {

void PlaneExtraction::extract(const SampleGrid& grid, const PlaneExtractionParameters& parameters,
                              const std::optional<geometry::Plane>& known)
{
  parameters_ = parameters;
  samples_.take(grid, parameters);
  growing_.grow(samples_, parameters, segments_);
  contacts_.find(samples_, segments_);
  joining_.join(parameters, contacts_, segments_);
  if (known && !SegmentJoining::has(segments_, *known, parameters)) {
    segments_.all.emplace_back();
    segments_.all.back().fit.plane = *known;
  }
  assignSamples();
  refit();
  listMembers();
}

void PlaneExtraction::assignSamples()
{
  const auto limit = static_cast<float>(parameters_.inlier_sigmas * parameters_.inlier_sigmas);
  const auto cosine = static_cast<float>(parameters_.normal_cosine);
  references_.clear();
  for (const PlaneSegment& segment : segments_.all) references_.emplace_back(segment.fit.plane);
  for (std::uint32_t k = 0; k < samples_.size(); ++k) {
    const NoisySample& sample = samples_[k];
    int& own = segments_.of_sample[k];
    // What has grown together stays together: where two planes meet, the nearest alone would mix them.
    if (own != PlaneSegments::kNone || !sample.has_normal) continue;
    float nearest = limit;
    for (std::size_t s = 0; s < references_.size(); ++s) {
      if (!(references_[s].normal.dot(sample.normal) > cosine)) continue;
      const float deviation = references_[s].deviation(sample);
      if (!(deviation < nearest)) continue;
      nearest = deviation;
      own = static_cast<int>(s);
    }
    if (own != PlaneSegments::kNone)
      segments_.all[static_cast<std::size_t>(own)].add(sample,
                                                       references_[static_cast<std::size_t>(own)].normal);
  }
}

void PlaneExtraction::refit()
{
  number_.assign(segments_.all.size(), PlaneSegments::kNone);
  std::size_t kept = 0;
  for (std::size_t s = 0; s < segments_.all.size(); ++s) {
    PlaneSegment& segment = segments_.all[s];
    if (!segment.refit(segment.fit.plane.normal, parameters_)) continue;
    number_[s] = static_cast<int>(kept);
    segments_.all[kept++] = segment;
  }
  segments_.all.resize(kept);
  segments_.renumber(number_);
}

void PlaneExtraction::listMembers()
{
  planes_.clear();
  std::uint32_t first = 0;
  for (const PlaneSegment& segment : segments_.all) {
    planes_.push_back({segment.fit, first, 0});
    first += static_cast<std::uint32_t>(segment.points.count());
  }
  members_.resize(first);
  for (std::uint32_t k = 0; k < samples_.size(); ++k) {
    if (segments_.of_sample[k] == PlaneSegments::kNone) continue;
    ExtractedPlane& plane = planes_[static_cast<std::size_t>(segments_.of_sample[k])];
    members_[plane.first + plane.size++] = k;
  }
}

}  // namespace polygonal_perception::perception

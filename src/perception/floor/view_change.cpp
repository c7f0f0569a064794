#include "polygonal_perception/perception/floor/view_change.hpp"

#include <algorithm>
#include <cmath>

namespace polygonal_perception::perception {

bool ViewChange::update(const SampleGrid& grid, const Parameters& parameters)
{
  const auto other_range = static_cast<float>(parameters.other_range);
  const auto& samples = grid.samples();
  const bool comparable = ranges_.size() == samples.size();
  ranges_.resize(samples.size(), 0.0F);
  std::size_t compared = 0;
  std::size_t changed = 0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const float before = ranges_[k];
    const float now = samples[k].has_point ? samples[k].point.norm() : 0.0F;
    ranges_[k] = now;
    if (!(before > 0.0F && now > 0.0F)) continue;
    ++compared;
    changed += std::abs(now - before) > other_range * std::min(now, before) ? 1 : 0;
  }
  const auto share = [](std::size_t part, std::size_t whole) {
    return static_cast<double>(part) / static_cast<double>(whole);
  };
  return comparable && compared > 0 && share(compared, samples.size()) > parameters.least_compared &&
         share(changed, compared) > parameters.most_changed;
}

}  // namespace polygonal_perception::perception

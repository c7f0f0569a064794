#include "perception/floor/segmentation.hpp"

#include <algorithm>
#include <cmath>

#include "perception/floor/depth_noise.hpp"

namespace polygonal_perception::perception {

namespace {

constexpr int kUpright = -2;  // a sample that waits for its segment

/// The plane distance d(s_m, s_n), eq. 5.
float planeDistance(const Sample& m, const Sample& n)
{
  const Eigen::Vector3f step = n.point - m.point;
  return std::abs(m.normal.dot(step)) + std::abs(n.normal.dot(step));
}

}  // namespace

void Segmentation::segment(const SampleGrid& grid, const Eigen::Vector3f& up, float least_upright,
                           float cluster_distance)
{
  const std::vector<Sample>& samples = grid.samples();
  segment_of_.assign(samples.size(), kNone);
  height_noise_.resize(samples.size());
  members_.clear();
  segments_.clear();
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const Sample& sample = samples[k];
    if (!sample.has_normal || !(sample.normal.dot(up) > least_upright)) continue;
    segment_of_[k] = kUpright;
    const float range = sample.point.norm();
    height_noise_[k] = depthNoise(range) * std::abs(sample.normal.dot(sample.point)) / std::max(range, 1e-3F);
  }
  for (std::uint32_t k = 0; k < samples.size(); ++k) {
    if (segment_of_[k] == kUpright) flood(grid, k, cluster_distance);
  }
}

void Segmentation::flood(const SampleGrid& grid, std::uint32_t seed, float cluster_distance)
{
  // Both terms of eq. 5 hold the noise of two points and of a normal made of two more.
  constexpr float kNoiseFactor = 3.0F;
  const auto id = static_cast<int>(segments_.size());
  Segment segment{static_cast<std::uint32_t>(members_.size()), 0};
  const std::vector<Sample>& samples = grid.samples();
  const auto columns = static_cast<std::uint32_t>(grid.samplesX());
  const auto rows = static_cast<std::uint32_t>(grid.samplesY());

  segment_of_[seed] = id;
  members_.push_back(seed);
  // The members themselves are the queue of samples whose neighbours are still to be looked at.
  for (std::size_t next = segment.first; next < members_.size(); ++next) {
    const std::uint32_t here = members_[next];
    const auto visit = [&](std::uint32_t there) {
      if (segment_of_[there] != kUpright) return;
      const float threshold =
          std::max(cluster_distance, kNoiseFactor * (height_noise_[here] + height_noise_[there]));
      if (!(planeDistance(samples[here], samples[there]) < threshold)) return;
      segment_of_[there] = id;
      members_.push_back(there);
    };
    const std::uint32_t i = here % columns;
    const std::uint32_t j = here / columns;
    if (i + 1 < columns) visit(here + 1);
    if (i > 0) visit(here - 1);
    if (j + 1 < rows) visit(here + columns);
    if (j > 0) visit(here - columns);
  }
  segment.size = static_cast<std::uint32_t>(members_.size()) - segment.first;
  segments_.push_back(segment);
}

}  // namespace polygonal_perception::perception

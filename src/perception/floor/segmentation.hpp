#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "polygonal_perception/perception/floor/sample_grid.hpp"

namespace polygonal_perception::perception {

/// Joins neighbouring upright samples that lie on one surface (section III-C, algorithm 1).
class Segmentation
{
public:
  struct Segment
  {
    std::uint32_t first = 0;  ///< its samples are members()[first .. first + size)
    std::uint32_t size = 0;
  };

  static constexpr int kNone = -1;

  /// @param up                unit up vector
  /// @param least_upright     cosine of the largest angle between `up` and the normal of an upright sample
  ///                          (eq. 3)
  /// @param cluster_distance  [m] tau_l, the least threshold of the plane distance (eq. 5); the samples'
  ///                          depth noise raises it where they are far away
  void segment(const SampleGrid& grid, const Eigen::Vector3f& up, float least_upright,
               float cluster_distance);

  const std::vector<Segment>& segments() const { return segments_; }
  /// Indices into the grid's samples, segment by segment.
  const std::vector<std::uint32_t>& members() const { return members_; }
  /// The segment of each sample of the grid, or kNone.
  const std::vector<int>& segmentOf() const { return segment_of_; }

private:
  void flood(const SampleGrid& grid, std::uint32_t seed, float cluster_distance);

  std::vector<float> height_noise_;
  std::vector<int> segment_of_;
  std::vector<std::uint32_t> members_;
  std::vector<Segment> segments_;
};

}  // namespace polygonal_perception::perception

#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "polygonal_perception/geometry/plane.hpp"
#include "polygonal_perception/perception/planes/sample_grid.hpp"

namespace polygonal_perception::reference {

/// Sections III-B to III-D of the paper word by word, as a baseline: samples are sorted along the up vector,
/// flooded with a fixed threshold, and algorithm 2 merges or replaces the floor hypothesis. Only the flood
/// fill is not recursive and the averages are weighted.
class PaperFloorDetector
{
public:
  /// @return the floor; nothing where no sample is upright or its points do not span a plane
  std::optional<geometry::Plane> detect(const perception::SampleGrid& grid, const Eigen::Vector3d& up);

private:
  void flood(const perception::SampleGrid& grid, std::size_t seed);

  std::vector<bool> waiting_;  // sigma of algorithm 1
  std::vector<std::size_t> order_;
  std::vector<std::size_t> segment_;
  std::vector<std::size_t> floor_;
};

}  // namespace polygonal_perception::reference

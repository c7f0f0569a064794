#pragma once

#include <cstdint>
#include <vector>

#include "perception/planes/plane_segment.hpp"

namespace polygonal_perception::perception {

/// Joins neighbouring samples that lie on one plane (section III-C, algorithm 1), without pruning or sorting, so
/// that all planes are found (III-B, last lines).
///
/// Two things differ from algorithm 1. A flood fill compares neighbours alone, and leaks where two planes meet at a
/// small angle or over a step that the noise hides; so a sample must also lie on the plane that has grown so far.
/// And the flood fills start where the samples' normals agree best, not from the lowest: a plane should know its
/// normal before it comes to an edge.
class RegionGrowing
{
public:
  /// Grows the segments of a frame anew.
  void grow(const NoisySamples& samples, const PlaneExtractionParameters& parameters,
            PlaneSegments& segments);

private:
  void sortByFlatness(const NoisySamples& samples);
  void flood(std::uint32_t seed, const NoisySamples& samples, const PlaneExtractionParameters& parameters,
             PlaneSegments& segments);

  std::vector<float> least_cosine_;     // of each sample, between its normal and its neighbours'
  std::vector<std::uint32_t> seeds_;    // the samples with a normal, the flattest first
  std::vector<std::uint32_t> members_;  // of the segment that grows
};

}  // namespace polygonal_perception::perception

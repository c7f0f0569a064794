#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "perception/planes/noisy_sample.hpp"
#include "perception/planes/plane_segment.hpp"

namespace polygonal_perception::perception {

/// Where the segments of a frame touch: a lens bends a plane slowly, so that it may fall into pieces, whose planes agree
/// there; those of two surfaces a step apart do not.
class SegmentContacts
{
public:
  /// Looks at the borders of a frame's segments anew.
  void find(const NoisySamples& samples, const PlaneSegments& segments);

  /// [m] The middle of the border of two segments; nothing where they do not touch.
  std::optional<Eigen::Vector3d> middle(std::size_t a, std::size_t b) const;

  /// One segment joins another: its borders are the other's.
  void join(std::size_t from, std::size_t into);

private:
  struct Border
  {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();  // [m] of the points of both sides
    std::uint32_t count = 0;                        // of them
  };
  void add(std::size_t a, std::size_t b, const Border& more);

  std::size_t size_ = 0;  // segments
  std::vector<Border> borders_;
};

}  // namespace polygonal_perception::perception

#pragma once

#include <array>
#include <string>

namespace polygonal_perception::parameters {

/// A box along the axes of a frame, as a parameter: [frame, x, y, z from, x, y, z to].
struct FrameBox
{
  std::string frame;
  std::array<double, 3> from{};  ///< [m] the lower corner: x, y, z
  std::array<double, 3> to{};    ///< [m] the upper one
};

}  // namespace polygonal_perception::parameters

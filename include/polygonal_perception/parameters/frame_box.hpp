#pragma once

#include <Eigen/Geometry>
#include <string>

namespace polygonal_perception::parameters {

/// A box along the axes of a frame, as a parameter: [frame, x, y, z from, x, y, z to].
struct FrameBox
{
  std::string frame;
  Eigen::AlignedBox3d extent;  ///< [m]
};

}  // namespace polygonal_perception::parameters

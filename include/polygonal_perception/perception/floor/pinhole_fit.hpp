#pragma once

#include <Eigen/Core>
#include <optional>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/perception/planes/sample_grid.hpp"

namespace polygonal_perception::perception {

/// The pinhole camera that a cloud's pixels come from, in the cloud's frame, whatever its axes are.
struct Pinhole
{
  /// Pixel (u, v) looks along this times (u, v, 1).
  Eigen::Matrix3d direction_of_pixel = Eigen::Matrix3d::Identity();
  Eigen::Vector3d centre = Eigen::Vector3d::UnitZ();  ///< unit; where the middle of the image looks
};

/// Reads off the pixels of a cloud where they look, which is the same whatever they see. So a view that has returns on one
/// side only changes nothing.
///
/// @return nothing where the samples have too few points, or no pinhole looks like that
POLYGONAL_PERCEPTION_EXPORT std::optional<Pinhole> fitPinhole(const SampleGrid& samples);

}  // namespace polygonal_perception::perception

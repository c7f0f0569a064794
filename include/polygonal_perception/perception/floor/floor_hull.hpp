#pragma once

#include <Eigen/Core>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/plane.hpp"
#include "polygonal_perception/perception/floor/floor_detector.hpp"
#include "polygonal_perception/perception/planes/sample_grid.hpp"

namespace polygonal_perception::perception {

/// The convex hull of the floor samples, projected onto the floor plane (figure 3 of the paper).
///
/// @param samples  the samples of a frame
/// @param labels   what became of each, in the same order
/// @param floor    the plane that was found in it
/// @return the corners in the samples' frame, counter-clockwise seen from above; empty where the samples of
///         the floor lie on one line
POLYGONAL_PERCEPTION_EXPORT std::vector<Eigen::Vector3f> floorHull(const SampleGrid& samples,
                                                                   const std::vector<SampleLabel>& labels,
                                                                   const geometry::Plane& floor);

}  // namespace polygonal_perception::perception

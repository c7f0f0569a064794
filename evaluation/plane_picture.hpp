#pragma once

#include <opencv2/core.hpp>

#include "polygonal_perception/cameras/simulation/simulated_camera.hpp"
#include "polygonal_perception/perception/segmentation/segmented_planes.hpp"

namespace polygonal_perception::evaluation {

/// The true planes of a rendered frame in muted colours, black what lies on none, and the boundaries of those that were
/// found, each with its id and its kind's first letter.
cv::Mat3b drawPlanes(const simulation::PinholeCamera& camera, const simulation::SimulatedFrame& frame,
                     const perception::SegmentedPlanes& planes);

}  // namespace polygonal_perception::evaluation

#pragma once

#include <opencv2/core.hpp>

#include "polygonal_perception/cameras/simulation/simulated_camera.hpp"
#include "polygonal_perception/perception/segmentation/segmented_planes.hpp"

namespace polygonal_perception::evaluation {

/// The true planes of a rendered frame in muted colours, black what lies on none.
cv::Mat3b paintTruth(const simulation::PinholeCamera& camera, const simulation::SimulatedFrame& frame);

/// A depth image [m] in shades of grey, the nearest brightest, black what gave no return.
cv::Mat3b paintDepth(const cv::Mat1f& depth);

/// Draws the boundaries of planes that were found, each with its id and its kind's first letter.
void drawPlanes(const perception::SegmentedPlanes& planes, double fx, double fy, double cx, double cy,
                cv::Mat3b& picture);

}  // namespace polygonal_perception::evaluation

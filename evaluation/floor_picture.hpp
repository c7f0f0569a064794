#pragma once

#include <opencv2/core.hpp>

#include "polygonal_perception/perception/floor/floor_detector.hpp"
#include "polygonal_perception/perception/planes/sample_grid.hpp"

namespace polygonal_perception::evaluation {

/// The depth image in grey with the samples on it, as figure 3 of the paper: green the floor set, blue other
/// segments, red pruned; no mark where there is no return.
cv::Mat3b drawFloor(const cv::Mat1f& depth, const perception::SampleGrid& grid,
                    const std::vector<perception::SampleLabel>& labels);

}  // namespace polygonal_perception::evaluation

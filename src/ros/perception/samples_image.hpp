#pragma once

#include <sensor_msgs/Image.h>
#include <std_msgs/Header.h>

#include <Eigen/Core>
#include <vector>

#include "polygonal_perception/perception/floor/floor_detector.hpp"
#include "polygonal_perception/perception/input/point_view.hpp"
#include "polygonal_perception/perception/planes/sample_grid.hpp"

namespace polygonal_perception::ros_perception {

/// The depth image in grey, near is bright, with a dot a sample that tells what became of it (figure 3 of the
/// paper): grey without depth, red pruned, yellow in a segment that is not the floor, green floor.
///
/// @param header   stamp and frame of the input
/// @param forward  unit axis along which depth is measured, in the input's frame
sensor_msgs::ImagePtr toSamplesImage(const std_msgs::Header& header, const perception::PointView& points,
                                     const perception::SampleGrid& samples,
                                     const std::vector<perception::SampleLabel>& labels,
                                     const Eigen::Vector3d& forward);

}  // namespace polygonal_perception::ros_perception

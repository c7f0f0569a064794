#pragma once

#include "polygonal_perception/perception/products.hpp"
#include "polygonal_perception/ros/common/output_table.hpp"
#include "ros/perception/frame_result.hpp"

namespace polygonal_perception::ros_perception {

using Outputs = ros_common::OutputTable<FrameResult, perception::Products>;

/// Adds the node's topics. A new one is an entry here.
void addOutputs(Outputs& outputs);

}  // namespace polygonal_perception::ros_perception

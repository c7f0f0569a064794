#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "polygonal_perception/perception/pipeline.hpp"
#include "polygonal_perception/planning/path_planner.hpp"

namespace polygonal_perception::evaluation {

/// A frame, its polygons, and a plan among them.
struct PlannedFrame
{
  const cv::Mat1f& depth;  ///< [m] NaN or 0: no return
  const perception::PinholeRays& rays;
  const perception::Pipeline::Result& result;
  const planning::PathPlanner& planner;
  const planning::Plan& plan;  ///< in the floor frame
};

/// The upper half of the paper's figure 7: what the camera sees, with the polygons red and the path green on the floor, where
/// the floor is seen; beside it the same from above, with the part of the visibility graph that was built in grey.
cv::Mat3b drawPlan(const PlannedFrame& frame, const std::string& title);

}  // namespace polygonal_perception::evaluation

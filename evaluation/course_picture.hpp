#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "reference/course_run.hpp"

namespace polygonal_perception::evaluation {

/// The ground of a course from the side, stretched in height, with the robot's places on it in the colour of each
/// frame's floor (green FOUND, orange HELD, blue ASSUMED, red NOT_FOUND); below it a red bar for each frame with
/// cells that are occupied without reason within 2.5 m, as long as there are many, and a black one where the floor is
/// off.
cv::Mat3b drawCourse(const simulation::Scene& scene, const std::vector<reference::CourseFrame>& frames,
                     const std::string& title);

/// What the camera sees in grey, ground light and the floor lighter in a second picture, and the occupied cells from
/// above: black, and red where no obstacle is.
cv::Mat3b drawCourseFrame(const reference::CourseRun& run, const std::string& title);

}  // namespace polygonal_perception::evaluation

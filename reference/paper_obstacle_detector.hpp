#pragma once

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <vector>

#include "polygonal_perception/geometry/plane.hpp"
#include "polygonal_perception/perception/input/point_view.hpp"

namespace polygonal_perception::reference {

/// Section IV of the paper word by word, as a baseline: every point is transformed, one after the other, with
/// the rotation that turns the floor's normal to z; OpenCV dilates the grid, finds the contours and
/// simplifies them with Douglas-Peucker. Its shortcomings (see README.md) are the paper's.
class PaperObstacleDetector
{
public:
  /// @return the polygons, in cells
  const std::vector<std::vector<cv::Point>>& process(const perception::PointView& points,
                                                     const geometry::Plane& floor);

private:
  cv::Mat grid_;
  std::vector<Eigen::Vector3f> world_;
  std::vector<std::vector<cv::Point>> contours_;
};

}  // namespace polygonal_perception::reference

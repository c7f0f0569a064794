#pragma once

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <vector>

#include "polygonal_perception/plane.hpp"
#include "polygonal_perception/point_view.hpp"

namespace polygonal_perception {
namespace benchmarks {

/// Section IV of the paper word by word, as a baseline: every point is transformed, one after the other, with
/// the rotation that turns the floor's normal to z; OpenCV dilates the grid, finds the contours and
/// simplifies them with Douglas-Peucker. Its shortcomings (see README.md) are the paper's.
class PaperAlgorithm
{
public:
  /// @return the polygons, in cells
  const std::vector<std::vector<cv::Point>>& process(const PointView& points, const Plane& floor);

private:
  cv::Mat grid_;
  std::vector<Eigen::Vector3f> world_;
  std::vector<std::vector<cv::Point>> contours_;
};

}  // namespace benchmarks
}  // namespace polygonal_perception

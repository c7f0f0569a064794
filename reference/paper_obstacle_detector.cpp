#include "reference/paper_obstacle_detector.hpp"

#include <opencv2/imgproc.hpp>

namespace polygonal_perception::reference {

const std::vector<std::vector<cv::Point>>& PaperObstacleDetector::process(const perception::PointView& points,
                                                                          const geometry::Plane& floor)
{
  constexpr int kCells = 100;
  constexpr float kResolution = 0.05F;
  constexpr int kRobotRadius = 6;  // [cells]
  constexpr float kLowest = 0.03F;
  constexpr float kHighest = 0.60F;
  constexpr double kTolerance = 1.0;  // [cells]

  // The paper's camera frame has x forward and z up.
  Eigen::Matrix3d from_optical;
  from_optical << 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, -1.0, 0.0;
  const Eigen::Vector3d normal = from_optical * floor.normal;
  const Eigen::Vector3d axis = normal.cross(Eigen::Vector3d::UnitZ()).normalized();
  Eigen::Isometry3d to_world = Eigen::Isometry3d::Identity();
  to_world.linear() = Eigen::AngleAxisd(std::acos(normal.z()), axis).toRotationMatrix() * from_optical;
  to_world.translation().z() = floor.distance;
  const Eigen::Isometry3f transform = to_world.cast<float>();

  world_.clear();
  for (std::uint32_t v = 0; v < points.height(); ++v) {
    for (std::uint32_t u = 0; u < points.width(); ++u) world_.emplace_back(transform * points.point(u, v));
  }
  grid_.create(kCells, kCells, CV_8UC1);
  grid_.setTo(0);
  for (const Eigen::Vector3f& p : world_) {
    if (!(p.z() > kLowest && p.z() < kHighest)) continue;
    const float i = p.x() / kResolution;
    const float j = (p.y() + 0.5F * kCells * kResolution) / kResolution;
    if (i >= 0.0F && i < kCells && j >= 0.0F && j < kCells) {
      grid_.at<std::uint8_t>(static_cast<int>(j), static_cast<int>(i)) = 1;
    }
  }
  const cv::Size kernel_size(2 * kRobotRadius + 1, 2 * kRobotRadius + 1);
  cv::dilate(grid_, grid_, cv::getStructuringElement(cv::MORPH_ELLIPSE, kernel_size));
  contours_.clear();
  cv::findContours(grid_, contours_, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  for (auto& contour : contours_) cv::approxPolyDP(contour, contour, kTolerance, true);
  return contours_;
}

}  // namespace polygonal_perception::reference

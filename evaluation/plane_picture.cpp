#include "plane_picture.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

namespace polygonal_perception::evaluation {

namespace {

/// Numbers that follow one another get hues far apart.
cv::Scalar colour(std::uint32_t number, double saturation, double value)
{
  constexpr double kGoldenRatio = 0.618033988749895;
  const double hue = std::fmod(number * kGoldenRatio, 1.0);
  const cv::Mat3b hsv(1, 1,
                      cv::Vec3b(static_cast<uchar>(180.0 * hue), static_cast<uchar>(255.0 * saturation),
                                static_cast<uchar>(255.0 * value)));
  cv::Mat3b bgr;
  cv::cvtColor(hsv, bgr, cv::COLOR_HSV2BGR);
  return cv::Scalar(bgr(0, 0));
}

}  // namespace

cv::Mat3b paintTruth(const simulation::PinholeCamera& camera, const simulation::SimulatedFrame& frame)
{
  cv::Mat3b picture(static_cast<int>(camera.height), static_cast<int>(camera.width), cv::Vec3b(0, 0, 0));
  for (std::size_t k = 0; k < camera.size(); ++k) {
    const std::uint16_t number = frame.truth.plane[k];
    if (number == simulation::ScenePlanes::kNone) continue;
    const cv::Scalar muted = colour(number, 0.5, frame.depth[k] > 0.0F ? 0.45 : 0.25);
    picture(static_cast<int>(k)) =
        cv::Vec3b(static_cast<uchar>(muted[0]), static_cast<uchar>(muted[1]), static_cast<uchar>(muted[2]));
  }
  return picture;
}

cv::Mat3b paintDepth(const cv::Mat1f& depth)
{
  cv::Mat3b picture(depth.size(), cv::Vec3b(0, 0, 0));
  for (int v = 0; v < depth.rows; ++v) {
    for (int u = 0; u < depth.cols; ++u) {
      const auto grey = static_cast<uchar>(150.0F / (1.0F + depth(v, u)));
      if (depth(v, u) > 0.0F) picture(v, u) = cv::Vec3b(grey, grey, grey);
    }
  }
  return picture;
}

void drawPlanes(const perception::SegmentedPlanes& planes, double fx, double fy, double cx, double cy,
                cv::Mat3b& picture)
{
  constexpr const char* kKinds = "?FHVS";
  for (const perception::SegmentedPlane& plane : planes.planes) {
    std::vector<cv::Point> ring;
    cv::Point2d middle(0.0, 0.0);
    for (std::uint32_t k = 0; k < plane.vertex_count; ++k) {
      const Eigen::Vector3f& p = planes.vertices[plane.first_vertex + k];
      const cv::Point2d pixel(cx + fx * p.x() / p.z(), cy + fy * p.y() / p.z());
      ring.emplace_back(pixel);
      middle += pixel / static_cast<double>(plane.vertex_count);
    }
    const cv::Scalar bright = colour(plane.id, 0.6, 1.0);
    cv::polylines(picture, ring, true, bright, 2, cv::LINE_AA);
    cv::putText(picture, std::to_string(plane.id) + kKinds[static_cast<std::size_t>(plane.kind)], middle,
                cv::FONT_HERSHEY_SIMPLEX, 0.6, bright, 2, cv::LINE_AA);
  }
}

}  // namespace polygonal_perception::evaluation

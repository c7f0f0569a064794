#include "paths/plan_picture.hpp"

#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "polygonal_perception/geometry/distance.hpp"
#include "polygonal_perception/geometry/location.hpp"

namespace polygonal_perception::evaluation {

namespace {

const cv::Vec3b kRed(50, 50, 220);
const cv::Vec3b kGreen(60, 170, 40);
const cv::Scalar kGrey(150, 150, 150);
const cv::Scalar kBlack(0, 0, 0);

constexpr double kLow = 0.04;       // [m] what is lower counts as the floor
constexpr double kHalfPath = 0.04;  // [m] of its width
constexpr double kAhead = 5.5;      // [m] that are shown from above
constexpr double kBehind = 0.5;

double distanceTo(const std::vector<Eigen::Vector2d>& path, const Eigen::Vector2d& point)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    least = std::min(least, (geometry::nearestOnSegment(point, path[i], path[i + 1]) - point).norm());
  return least;
}

void blend(cv::Vec3b& pixel, const cv::Vec3b& colour, double share)
{
  for (int c = 0; c < 3; ++c)
    pixel[c] = cv::saturate_cast<uchar>((1.0 - share) * pixel[c] + share * colour[c]);
}

cv::Mat3b drawView(const PlannedFrame& frame)
{
  cv::Mat3b picture(frame.depth.size());
  for (int v = 0; v < picture.rows; ++v) {
    for (int u = 0; u < picture.cols; ++u) {
      const float z = frame.depth(v, u);
      const bool is_seen = z > 0.0F;  // NaN is not
      const auto grey = static_cast<uchar>(is_seen ? 245.0F / (1.0F + 0.3F * z) : 20.0F);
      cv::Vec3b& pixel = picture(v, u) = {grey, grey, grey};
      const Eigen::Vector3d ray(frame.rays.column_slope[u], frame.rays.row_slope[v], 1.0);
      if (is_seen && (frame.result.to_floor_frame * (ray * double{z})).z() > kLow) continue;
      // Where the ray meets the floor.
      const Eigen::Vector3d origin = frame.result.to_floor_frame.translation();
      const Eigen::Vector3d direction = frame.result.to_floor_frame.linear() * ray;
      if (!(direction.z() < 0.0)) continue;
      const Eigen::Vector2d place = (origin - origin.z() / direction.z() * direction).head<2>();
      if (place.norm() > 2.0 * kAhead) continue;
      if (distanceTo(frame.plan.path, place) < kHalfPath)
        pixel = kGreen;
      else if (geometry::locate(place, frame.result.polygons) == geometry::Location::kInside)
        blend(pixel, kRed, 0.55);
    }
  }
  return picture;
}

cv::Mat3b drawFromAbove(const PlannedFrame& frame, int rows)
{
  const double scale = rows / (kAhead + kBehind);
  constexpr int kBits = 4;  // of a pixel, for OpenCV's lines
  const int columns = rows * 4 / 5;
  const auto toPicture = [&](const Eigen::Vector2d& p) {
    // Ahead is up.
    const double x = columns / 2.0 - scale * p.y();
    const double y = rows - scale * (p.x() + kBehind);
    return cv::Point(static_cast<int>(std::lround(x * (1 << kBits))),
                     static_cast<int>(std::lround(y * (1 << kBits))));
  };
  cv::Mat3b picture(rows, columns, cv::Vec3b(255, 255, 255));
  std::vector<std::vector<cv::Point>> rings;
  for (const auto& ring : frame.result.polygons.rings) {
    rings.emplace_back();
    for (const Eigen::Vector2d& p : frame.result.polygons.view(ring)) rings.back().push_back(toPicture(p));
  }
  if (!rings.empty()) {
    cv::fillPoly(picture, rings, cv::Scalar(200, 200, 250), cv::LINE_AA, kBits);
    cv::polylines(picture, rings, true, cv::Scalar(kRed), 1, cv::LINE_AA, kBits);
  }
  const occupancy::BinaryGrid& grid = frame.result.occupancy;
  const occupancy::GridGeometry& geometry = grid.geometry();
  for (int j = 0; j < grid.cellsY(); ++j) {
    for (int i = 0; i < grid.cellsX(); ++i) {
      if (!grid.occupied(i, j)) continue;
      cv::circle(picture,
                 toPicture(Eigen::Vector2d(geometry.origin_x, geometry.origin_y) +
                           geometry.resolution * Eigen::Vector2d(i + 0.5, j + 0.5)),
                 1 << kBits, kBlack, cv::FILLED, cv::LINE_AA, kBits);
    }
  }
  std::vector<planning::PathSearch::SeenEdge> edges;
  frame.planner.search().seenEdges(edges);
  for (const auto& edge : edges)
    cv::line(picture, toPicture(edge.from), toPicture(edge.to), kGrey, 1, cv::LINE_AA, kBits);
  for (std::size_t i = 0; i + 1 < frame.plan.path.size(); ++i)
    cv::line(picture, toPicture(frame.plan.path[i]), toPicture(frame.plan.path[i + 1]), cv::Scalar(kGreen), 3,
             cv::LINE_AA, kBits);
  cv::circle(picture, toPicture(frame.plan.path.front()), 5 << kBits, cv::Scalar(kGreen), cv::FILLED,
             cv::LINE_AA, kBits);
  return picture;
}

}  // namespace

cv::Mat3b drawPlan(const PlannedFrame& frame, const std::string& title)
{
  const cv::Mat3b view = drawView(frame);
  const cv::Mat3b above = drawFromAbove(frame, view.rows);
  cv::Mat3b picture;
  cv::hconcat(view, above, picture);
  cv::rectangle(picture, {0, 0}, {view.cols, 18}, cv::Scalar(255, 255, 255), cv::FILLED);
  cv::putText(picture, title, {6, 13}, cv::FONT_HERSHEY_SIMPLEX, 0.42, kBlack, 1, cv::LINE_AA);
  return picture;
}

}  // namespace polygonal_perception::evaluation

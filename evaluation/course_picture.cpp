#include "course_picture.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace polygonal_perception::evaluation {
namespace {

const cv::Vec3b kWhite(255, 255, 255);
const cv::Scalar kBlack(0, 0, 0);
const cv::Scalar kRed(40, 40, 220);

cv::Scalar colourOf(perception::FloorStatus status)
{
  switch (status) {
    case perception::FloorStatus::kFound:
      return {60, 160, 60};
    case perception::FloorStatus::kHeld:
      return {30, 150, 250};
    case perception::FloorStatus::kAssumed:
      return {230, 130, 40};
    default:
      return kRed;
  }
}

void write(cv::Mat3b& picture, const std::string& text, const cv::Point& at)
{
  cv::putText(picture, text, at, cv::FONT_HERSHEY_SIMPLEX, 0.42, kBlack, 1, cv::LINE_AA);
}

}  // namespace

cv::Mat3b drawCourse(const simulation::Scene& scene, const std::vector<reference::CourseFrame>& frames,
                     const std::string& title)
{
  constexpr int kWidth = 880;
  constexpr int kHeight = 120;
  constexpr int kGround = 70;    // the row of the floor
  constexpr double kUp = 150.0;  // [px/m]
  constexpr int kBars = 78;      // the row where bars begin
  constexpr int kLongest = 36;   // [px] of a bar
  double low = 1e9;
  double high = -1e9;
  for (const simulation::Solid& solid : scene.solids) {
    for (const Eigen::Vector3f& vertex : solid.vertices) {
      low = std::min(low, double{vertex.x()});
      high = std::max(high, double{vertex.x()});
    }
  }
  const auto column = [&](double x) { return static_cast<int>((x - low) / (high - low) * (kWidth - 1)); };
  const auto row = [&](double x) { return kGround - static_cast<int>(kUp * scene.groundHeight({x, 0.0})); };
  cv::Mat3b picture(kHeight, kWidth, kWhite);
  for (int k = 0; k + 1 < kWidth; ++k) {
    const double x = low + (high - low) * k / (kWidth - 1);
    cv::line(picture, {k, row(x)}, {k + 1, row(x + (high - low) / kWidth)}, kBlack, 1, cv::LINE_AA);
  }
  for (const reference::CourseFrame& frame : frames) {
    const int k = column(frame.x);
    cv::circle(picture, {k, row(frame.x) - 5}, 3, colourOf(frame.status), cv::FILLED, cv::LINE_AA);
    if (frame.false_cells > 0) {
      const int length = std::min(kLongest, 3 + static_cast<int>(6.0 * std::log(double(frame.false_cells))));
      cv::line(picture, {k, kBars}, {k, kBars + length}, kRed, 1);
    }
    if (frame.isOff()) cv::line(picture, {k, kGround + 2}, {k, kBars - 2}, kBlack, 2);
  }
  write(picture, title, {6, 14});
  return picture;
}

cv::Mat3b drawCourseFrame(const reference::CourseRun& run, const std::string& title)
{
  const simulation::SimulatedFrame& frame = run.frame();
  const simulation::PinholeCamera& camera = run.camera();
  const auto rows = static_cast<int>(camera.height);
  const auto columns = static_cast<int>(camera.width);
  cv::Mat3b picture(rows, 2 * columns + rows, kWhite);
  for (int v = 0; v < rows; ++v) {
    for (int u = 0; u < columns; ++u) {
      const auto k = static_cast<std::size_t>(v * columns + u);
      const float z = frame.depth[k];
      const auto grey = static_cast<uchar>(z > 0.0F ? 230.0F / (1.0F + 0.5F * z) : 0.0F);
      picture(v, u) = {grey, grey, grey};
      const simulation::Surface surface = frame.truth.surface[k];
      const uchar shade = surface == simulation::Surface::kFloor    ? 235
                          : surface == simulation::Surface::kGround ? 200
                                                                    : 110;
      picture(v, columns + u) = {shade, shade, shade};
    }
  }
  const occupancy::BinaryGrid& grid = run.result().occupancy;
  const double scale = static_cast<double>(rows) / std::max(grid.cellsX(), grid.cellsY());
  for (int j = 0; j < grid.cellsY(); ++j) {
    for (int i = 0; i < grid.cellsX(); ++i) {
      if (!grid.occupied(i, j)) continue;
      const cv::Point low(2 * columns + static_cast<int>(scale * (grid.cellsY() - 1 - j)),
                          static_cast<int>(scale * (grid.cellsX() - 1 - i)));
      cv::rectangle(picture, low, low + cv::Point(static_cast<int>(scale), static_cast<int>(scale)),
                    run.isFalse(i, j) ? kRed : kBlack, cv::FILLED);
    }
  }
  cv::rectangle(picture, {0, 0}, {2 * columns, 16}, cv::Scalar(255, 255, 255), cv::FILLED);
  write(picture, title, {4, 12});
  return picture;
}

}  // namespace polygonal_perception::evaluation

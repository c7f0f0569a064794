#include "polygon_score.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "polygonal_perception/geometry/measures.hpp"
#include "reference/douglas_peucker.hpp"
#include "reference/error_statistics.hpp"
#include "reference/polygon_checker.hpp"

namespace polygonal_perception::evaluation {
namespace {

constexpr double kMostVertices = 1.2;  // times the reference's

reference::CellLength inCells(double metres, double resolution)
{
  constexpr int kDenominator = 1000;
  return {std::llround(metres / resolution * kDenominator), kDenominator};
}

/// Counted on a raster that is finer than the grid.
double areaWithin(double radius, const occupancy::BinaryGrid& occupancy)
{
  constexpr int kFiner = 8;
  const occupancy::GridGeometry& geometry = occupancy.geometry();
  cv::Mat1b free(geometry.cells_y, geometry.cells_x);
  std::transform(occupancy.cells().begin(), occupancy.cells().end(), free.begin(),
                 [](std::uint8_t cell) { return cell == 0 ? 1 : 0; });
  cv::resize(free, free, cv::Size(), kFiner, kFiner, cv::INTER_NEAREST);
  cv::Mat1f distance;
  cv::distanceTransform(free, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  // From a pixel's centre to the nearest occupied one's is half a pixel more than to its side.
  const double unit = geometry.resolution / kFiner;
  return cv::countNonZero(distance < radius / unit + 0.5) * unit * unit;
}

}  // namespace

PolygonReference makePolygonReference(const PolygonTask& task)
{
  return {reference::verticesOfDouglasPeucker(task.inflated,
                                              task.tolerance / task.inflated.geometry().resolution),
          areaWithin(task.robot_radius, task.occupancy)};
}

void PolygonScore::add(const PolygonTask& task, const PolygonReference& reference,
                       const geometry::PolygonSet& polygons, double microseconds)
{
  const double resolution = task.inflated.geometry().resolution;
  const reference::PolygonChecker checker(
      task.occupancy, polygons, inCells(task.robot_radius, resolution),
      inCells(task.robot_radius + 1.5 * resolution + task.tolerance, resolution));
  ++frames_;
  crossing_ += checker.notSimple() || checker.wrongNesting() ? 1 : 0;
  unsafe_ += checker.unsafe() ? 1 : 0;
  loose_ += checker.loose() ? 1 : 0;
  vertices_ += polygons.vertices.size();
  reference_vertices_ += reference.vertices;
  if (reference.vertices > 0) {
    const double ratio =
        static_cast<double>(polygons.vertices.size()) / static_cast<double>(reference.vertices);
    large_ += ratio > kMostVertices ? 1 : 0;
    worst_vertices_ = std::max(worst_vertices_, ratio);
  }
  if (reference.area > 0.0) areas_.push_back(geometry::area(polygons) / reference.area);
  microseconds_.push_back(microseconds);
}

void PolygonScore::add(const PolygonScore& other)
{
  frames_ += other.frames_;
  vertices_ += other.vertices_;
  reference_vertices_ += other.reference_vertices_;
  large_ += other.large_;
  worst_vertices_ = std::max(worst_vertices_, other.worst_vertices_);
  crossing_ += other.crossing_;
  unsafe_ += other.unsafe_;
  loose_ += other.loose_;
  areas_.insert(areas_.end(), other.areas_.begin(), other.areas_.end());
  microseconds_.insert(microseconds_.end(), other.microseconds_.begin(), other.microseconds_.end());
}

std::string PolygonScore::head()
{
  return "frames | vertices | over DP | worst frame | area over needed | crossing | unsafe | loose | µs |";
}

std::string PolygonScore::rule()
{
  return "--: | --: | --: | --: | --: | --: | --: | --: | --: |";
}

std::string PolygonScore::row() const
{
  const double area = std::accumulate(areas_.begin(), areas_.end(), 0.0) /
                      static_cast<double>(std::max<std::size_t>(1, areas_.size()));
  char text[160];
  std::snprintf(
      text, sizeof text, "%zu | %zu | %.2f | %.2f | %.3f | %zu | %zu | %zu | %.1f |", frames_, vertices_,
      static_cast<double>(vertices_) / static_cast<double>(std::max<std::size_t>(1, reference_vertices_)),
      worst_vertices_, area, crossing_, unsafe_, loose_, reference::quantile(microseconds_, 0.5));
  return text;
}

}  // namespace polygonal_perception::evaluation

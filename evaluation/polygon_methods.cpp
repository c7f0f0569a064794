#include "polygon_methods.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "polygonal_perception/geometry/measures.hpp"
#include "polygonal_perception/occupancy/grid/bit_grid.hpp"
#include "polygonal_perception/occupancy/grid/inflation.hpp"
#include "polygonal_perception/occupancy/polygons/outline_tracer.hpp"
#include "polygonal_perception/occupancy/polygons/outlines.hpp"
#include "polygonal_perception/occupancy/polygons/polygonizer.hpp"

namespace polygonal_perception::evaluation {
namespace {

geometry::PolygonSet traceOutlines(const occupancy::BinaryGrid& cells)
{
  occupancy::BitGrid bits;
  bits.pack(cells);
  occupancy::Outlines outlines;
  occupancy::OutlineTracer().trace(bits, outlines);
  const occupancy::GridGeometry& geometry = cells.geometry();
  const double unit = geometry.resolution / occupancy::kUnitsPerCell;
  geometry::PolygonSet polygons;
  const auto add = [&](const occupancy::Outlines::Ring& ring) {
    std::vector<cv::Point2d> points;
    std::uint32_t vertex = ring.start;
    do {
      const occupancy::LatticePoint at = outlines.vertices[vertex].at;
      points.emplace_back(geometry.origin_x + at.x * unit, geometry.origin_y + at.y * unit);
      vertex = outlines.vertices[vertex].next;
    } while (vertex != ring.start);
    addRing(points, ring.hole, polygons);
  };
  for (std::size_t r = 0; r < outlines.rings.size(); ++r) {
    if (outlines.rings[r].hole) continue;
    add(outlines.rings[r]);
    for (const occupancy::Outlines::Ring& hole : outlines.rings) {
      if (hole.hole && hole.parent == r) add(hole);
    }
  }
  return polygons;
}

class ThisPackage : public PolygonMethod
{
public:
  std::string name() const override { return "this package"; }
  void polygonize(const PolygonTask& task, geometry::PolygonSet& polygons) override
  {
    if (polygonizer_.parameters().simplification_tolerance != task.tolerance)
      polygonizer_ = occupancy::Polygonizer({task.tolerance});
    polygonizer_.polygonize(task.occupancy, task.inflated, task.robot_radius, polygons);
  }

private:
  occupancy::Polygonizer polygonizer_{occupancy::Polygonizer::Parameters{}};
};

class NotSimplified : public PolygonMethod
{
public:
  std::string name() const override { return "outlines, not simplified"; }
  void polygonize(const PolygonTask& task, geometry::PolygonSet& polygons) override
  {
    polygons = task.outlines;
  }
};

/// Douglas-Peucker on the outlines, ring by ring.
class DouglasPeucker : public PolygonMethod
{
public:
  std::string name() const override { return "cv::approxPolyDP"; }
  void polygonize(const PolygonTask& task, geometry::PolygonSet& polygons) override
  {
    const occupancy::GridGeometry& geometry = task.inflated.geometry();
    const double unit = geometry.resolution / occupancy::kUnitsPerCell;
    polygons.clear();
    for (const geometry::PolygonSet::Ring& ring : task.outlines.rings) {
      points_.clear();
      for (const Eigen::Vector2d& vertex : task.outlines.view(ring)) {
        points_.emplace_back(cvRound((vertex.x() - geometry.origin_x) / unit),
                             cvRound((vertex.y() - geometry.origin_y) / unit));
      }
      cv::approxPolyDP(points_, points_, task.tolerance / unit, true);
      simplified_.clear();
      for (const cv::Point& point : points_)
        simplified_.emplace_back(geometry.origin_x + point.x * unit, geometry.origin_y + point.y * unit);
      addRing(simplified_, ring.hole, polygons);
    }
  }

private:
  std::vector<cv::Point> points_;
  std::vector<cv::Point2d> simplified_;
};

/// Section IV of the paper: vertices in the centres of cells, no holes.
class PaperPolygons : public PolygonMethod
{
public:
  std::string name() const override { return "paper: findContours, approxPolyDP"; }
  void polygonize(const PolygonTask& task, geometry::PolygonSet& polygons) override
  {
    const occupancy::GridGeometry& geometry = task.inflated.geometry();
    cells_.create(geometry.cells_y, geometry.cells_x);
    std::copy(task.inflated.cells().begin(), task.inflated.cells().end(), cells_.begin());
    cv::findContours(cells_, contours_, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    polygons.clear();
    for (auto& contour : contours_) {
      cv::approxPolyDP(contour, contour, task.tolerance / geometry.resolution, true);
      if (cv::contourArea(contour, true) < 0.0) std::reverse(contour.begin(), contour.end());
      centres_.clear();
      for (const cv::Point& cell : contour) {
        centres_.emplace_back(geometry.origin_x + (cell.x + 0.5) * geometry.resolution,
                              geometry.origin_y + (cell.y + 0.5) * geometry.resolution);
      }
      addRing(centres_, false, polygons);
    }
  }

private:
  cv::Mat1b cells_;
  std::vector<std::vector<cv::Point>> contours_;
  std::vector<cv::Point2d> centres_;
};

}  // namespace

PolygonTask makePolygonTask(const occupancy::BinaryGrid& occupancy, double robot_radius, double tolerance)
{
  PolygonTask task;
  task.occupancy = occupancy;
  task.robot_radius = robot_radius;
  task.tolerance = tolerance;
  occupancy::Inflation({robot_radius}).inflate(occupancy, task.inflated);
  task.outlines = traceOutlines(task.inflated);
  geometry::PolygonSet own;
  ThisPackage().polygonize(task, own);
  const double area = geometry::area(task.outlines);
  task.added_share = area > 0.0 ? geometry::area(own) / area - 1.0 : 0.0;
  return task;
}

std::vector<std::unique_ptr<PolygonMethod>> makePolygonMethods()
{
  std::vector<std::unique_ptr<PolygonMethod>> methods;
  methods.push_back(std::make_unique<ThisPackage>());
  methods.push_back(std::make_unique<NotSimplified>());
  methods.push_back(std::make_unique<PaperPolygons>());
  methods.push_back(std::make_unique<DouglasPeucker>());
#ifdef POLYGONAL_PERCEPTION_HAS_GEOS
  for (auto& method : makeGeosMethods()) methods.push_back(std::move(method));
#endif
#ifdef POLYGONAL_PERCEPTION_HAS_CGAL
  methods.push_back(makeCgalMethod());
#endif
  return methods;
}

}  // namespace polygonal_perception::evaluation

#include "polygon_picture.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "inflation_methods.hpp"
#include "occupancy_frames.hpp"
#include "polygon_methods.hpp"
#include "polygonal_perception/occupancy/grid/inflation.hpp"
#include "polygonal_perception/occupancy/polygons/polygonizer.hpp"

namespace polygonal_perception::evaluation {
namespace {

constexpr int kCell = 8;     // [px]
constexpr int kMargin = 10;  // [px]
constexpr int kHead = 34;    // [px]
constexpr int kDrives = 6;
constexpr int kFrames = 3;

const cv::Scalar kOccupied(60, 60, 60);
const cv::Scalar kInflated(205, 205, 205);
const cv::Scalar kPolygon(190, 100, 10);
const cv::Scalar kUnsafe(60, 60, 235);

/// Draws a grid as from above, with x, which is ahead, upwards.
class Panel
{
public:
  Panel(const std::string& title, const PolygonTask& task)
      : geometry_(task.inflated.geometry()),
        picture_(kCell * geometry_.cells_x, kCell * geometry_.cells_y, cv::Vec3b(255, 255, 255)),
        title_(title)
  {
    paint(task.inflated, kInflated);
    paint(task.occupancy, kOccupied);
  }

  /// Marks what is within the radius of an occupied cell and outside of the polygons.
  void markUnsafe(const PolygonTask& task, const geometry::PolygonSet& polygons)
  {
    cv::Mat1b free(picture_.size(), 1);
    for (int j = 0; j < geometry_.cells_y; ++j) {
      for (int i = 0; i < geometry_.cells_x; ++i) {
        if (task.occupancy.occupied(i, j)) free(square(i, j)) = 0;
      }
    }
    cv::Mat1f distance;
    cv::distanceTransform(free, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    const double unit = geometry_.resolution / kCell;
    cv::Mat1b unsafe = distance < task.robot_radius / unit - 0.5;
    std::vector<std::vector<cv::Point>> rings;
    for (const geometry::PolygonSet::Ring& ring : polygons.rings)
      rings.push_back(pixels(polygons.view(ring)));
    cv::Mat1b inside(picture_.size(), 0);
    cv::fillPoly(inside, rings, 255, cv::LINE_8, kShift);
    unsafe.setTo(0, inside);
    picture_.setTo(kUnsafe, unsafe);
  }

  void draw(const geometry::PolygonSet& polygons)
  {
    for (const geometry::PolygonSet::Ring& ring : polygons.rings) {
      const auto points = pixels(polygons.view(ring));
      cv::polylines(picture_, points, true, kPolygon, 2, cv::LINE_AA, kShift);
      for (const cv::Point& point : points)
        cv::circle(picture_, point, 3 << kShift, kPolygon, cv::FILLED, cv::LINE_AA, kShift);
    }
  }

  /// @param rows  [px] the part of the picture that is shown
  cv::Mat3b finished(const cv::Range& rows) const
  {
    cv::Mat3b framed;
    cv::copyMakeBorder(picture_.rowRange(rows), framed, kHead, kMargin, kMargin, kMargin, cv::BORDER_CONSTANT,
                       cv::Scalar::all(255));
    cv::rectangle(framed, cv::Rect(kMargin - 1, kHead - 1, picture_.cols + 2, rows.size() + 2),
                  cv::Scalar::all(120));
    cv::putText(framed, title_, cv::Point(kMargin, kHead - 12), cv::FONT_HERSHEY_SIMPLEX, 0.62,
                cv::Scalar::all(0), 1, cv::LINE_AA);
    return framed;
  }

private:
  static constexpr int kShift = 4;  // fractional bits of coordinates

  cv::Rect square(int i, int j) const
  {
    return cv::Rect(picture_.cols - kCell * (j + 1), picture_.rows - kCell * (i + 1), kCell, kCell);
  }
  void paint(const occupancy::BinaryGrid& cells, const cv::Scalar& colour)
  {
    for (int j = 0; j < geometry_.cells_y; ++j) {
      for (int i = 0; i < geometry_.cells_x; ++i) {
        if (cells.occupied(i, j)) picture_(square(i, j)).setTo(colour);
      }
    }
  }
  std::vector<cv::Point> pixels(const geometry::RingView& ring) const
  {
    std::vector<cv::Point> points;
    const double scale = kCell / geometry_.resolution * (1 << kShift);
    for (const Eigen::Vector2d& vertex : ring) {
      points.emplace_back(cvRound((picture_.cols << kShift) - (vertex.y() - geometry_.origin_y) * scale),
                          cvRound((picture_.rows << kShift) - (vertex.x() - geometry_.origin_x) * scale));
    }
    return points;
  }

  occupancy::GridGeometry geometry_;
  cv::Mat3b picture_;
  std::string title_;
};

cv::Mat3b legend(int width)
{
  cv::Mat3b strip(30, width, cv::Vec3b(255, 255, 255));
  int x = kMargin;
  const auto add = [&](const cv::Scalar& colour, const std::string& text, bool line) {
    const cv::Rect box(x, line ? 13 : 8, 22, line ? 3 : 14);
    cv::rectangle(strip, box, colour, cv::FILLED);
    cv::putText(strip, text, cv::Point(x + 30, 20), cv::FONT_HERSHEY_SIMPLEX, 0.5, cv::Scalar::all(0), 1,
                cv::LINE_AA);
    x += 30 + cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, 0.5, 1, nullptr).width + 28;
  };
  add(kOccupied, "occupied cell", false);
  add(kInflated, "inflated cell", false);
  add(kPolygon, "polygon", true);
  add(kUnsafe, "outside of the polygons, yet a robot there touches an obstacle", false);
  return strip;
}

/// The grid whose outlines have the most corners.
const occupancy::BinaryGrid& mostVaried(const std::vector<occupancy::BinaryGrid>& grids)
{
  const auto corners = [](const occupancy::BinaryGrid& grid) {
    return makePolygonTask(grid, occupancy::Inflation::Parameters{}.robot_radius, 0.0)
        .outlines.vertices.size();
  };
  return *std::max_element(grids.begin(), grids.end(),
                           [&](const occupancy::BinaryGrid& a, const occupancy::BinaryGrid& b) {
                             return corners(a) < corners(b);
                           });
}

/// The part of the picture that shows all inflated cells.
cv::Range rowsOf(const occupancy::BinaryGrid& inflated)
{
  constexpr int kAround = 3;  // [cells]
  int first = inflated.cellsX();
  int last = 0;
  for (int i = 0; i < inflated.cellsX(); ++i) {
    for (int j = 0; j < inflated.cellsY(); ++j) {
      if (!inflated.occupied(i, j)) continue;
      first = std::min(first, i);
      last = std::max(last, i);
    }
  }
  return {kCell * std::max(0, inflated.cellsX() - 1 - last - kAround),
          kCell * std::min(inflated.cellsX(), inflated.cellsX() - first + kAround)};
}

const auto& paperOf(const std::vector<std::unique_ptr<PolygonMethod>>& methods)
{
  return *std::find_if(methods.begin(), methods.end(),
                       [](const auto& method) { return method->name().find("paper") != std::string::npos; });
}

}  // namespace

void drawBeforeAndAfter(const std::string& file)
{
  const OccupancySet office = renderOccupancy("office", kDrives, kFrames);
  const double radius = occupancy::Inflation::Parameters{}.robot_radius;
  const double tolerance = occupancy::Polygonizer::Parameters{}.simplification_tolerance;
  PolygonTask task = makePolygonTask(mostVaried(office.grids), radius, tolerance);
  const auto methods = makePolygonMethods();
  const auto inflations = makeInflationMethods(radius, task.occupancy.geometry().resolution);

  geometry::PolygonSet polygons;
  Panel after("This package", task);
  methods.front()->polygonize(task, polygons);
  after.markUnsafe(task, polygons);
  after.draw(polygons);

  const cv::Range rows = rowsOf(task.inflated);
  inflations.back()->inflate(task.occupancy, task.inflated);
  Panel before("As in the paper: dilate, findContours, approxPolyDP", task);
  paperOf(methods)->polygonize(task, polygons);
  before.markUnsafe(task, polygons);
  before.draw(polygons);

  cv::Mat3b both;
  cv::hconcat(before.finished(rows), after.finished(rows), both);
  cv::vconcat(both, legend(both.cols), both);
  if (!cv::imwrite(file, both, {cv::IMWRITE_PNG_COMPRESSION, 9}))
    throw std::runtime_error("cannot write " + file);
}

}  // namespace polygonal_perception::evaluation

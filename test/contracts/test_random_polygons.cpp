#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <random>

#include "polygonal_perception/occupancy/grid/inflation.hpp"
#include "polygonal_perception/occupancy/polygons/polygonizer.hpp"
#include "reference/douglas_peucker.hpp"
#include "reference/polygon_checker.hpp"
#include "reference/random_grids.hpp"

namespace polygonal_perception::test {
namespace {

/// Lengths are given in thousandths of a cell, so that the checker can compare them without rounding.
struct Setting
{
  int radius;
  int tolerance;
  double resolution;

  reference::CellLength radiusInCells() const { return {radius, 1000}; }
  reference::CellLength limitInCells() const { return {radius + 1500 + tolerance, 1000}; }
};

// robot_radius 0, 0.05, 0.11, 0.225, 0.30 and 0.52 m and simplification_tolerance 0, 0.03, 0.05 and 0.15 m at
// 0.05 m a cell.
constexpr int kRadii[] = {0, 1000, 2200, 4500, 6000, 10400};
constexpr int kTolerances[] = {0, 600, 1000, 3000};

using Way = void (*)(const occupancy::BinaryGrid&, const Setting&, geometry::PolygonSet&,
                     occupancy::BinaryGrid&);

void thisPackage(const occupancy::BinaryGrid& occupancy, const Setting& setting,
                 geometry::PolygonSet& polygons, occupancy::BinaryGrid& inflated)
{
  const double radius = setting.radius * 0.001 * setting.resolution;
  inflated.reset(occupancy.geometry());
  occupancy::Inflation({radius}).inflate(occupancy, inflated);
  occupancy::Polygonizer({setting.tolerance * 0.001 * setting.resolution})
      .polygonize(occupancy, inflated, radius, polygons);
}

/// Section IV of the paper: vertices through the centres of dilated cells, simplified with Douglas-Peucker.
void paper(const occupancy::BinaryGrid& occupancy, const Setting& setting, geometry::PolygonSet& polygons,
           occupancy::BinaryGrid& inflated)
{
  const occupancy::GridGeometry& geometry = occupancy.geometry();
  cv::Mat1b cells(geometry.cells_y, geometry.cells_x);
  std::copy(occupancy.cells().begin(), occupancy.cells().end(), cells.begin());
  const int reach = setting.radius / 1000;
  const cv::Mat kernel = cv::getStructuringElement(cv::MORPH_ELLIPSE, cv::Size(2 * reach + 1, 2 * reach + 1));
  cv::dilate(cells, cells, kernel);
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(cells, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  polygons.clear();
  inflated.reset(geometry);
  for (auto& contour : contours) {
    cv::approxPolyDP(contour, contour, setting.tolerance * 0.001, true);
    polygons.rings.push_back({static_cast<std::uint32_t>(polygons.vertices.size()),
                              static_cast<std::uint32_t>(contour.size()), false});
    const bool clockwise = cv::contourArea(contour, true) < 0.0;
    if (clockwise) std::reverse(contour.begin(), contour.end());
    for (auto p = contour.begin(); p != contour.end(); ++p) {
      polygons.vertices.emplace_back(geometry.origin_x + (p->x + 0.5) * geometry.resolution,
                                     geometry.origin_y + (p->y + 0.5) * geometry.resolution);
    }
  }
}

std::optional<std::string> faultOf(Way way, const occupancy::BinaryGrid& grid, const Setting& setting)
{
  geometry::PolygonSet polygons;
  occupancy::BinaryGrid inflated;
  way(grid, setting, polygons, inflated);
  return reference::PolygonChecker(grid, polygons, setting.radiusInCells(), setting.limitInCells()).fault();
}

/// Frees cell after cell as long as the fault stays: what is left shows it best.
occupancy::BinaryGrid shrunk(Way way, occupancy::BinaryGrid grid, const Setting& setting)
{
  for (bool smaller = true; smaller;) {
    smaller = false;
    for (int j = 0; j < grid.cellsY(); ++j) {
      for (int i = 0; i < grid.cellsX(); ++i) {
        if (!grid.occupied(i, j)) continue;
        grid.set(i, j, false);
        if (faultOf(way, grid, setting)) {
          smaller = true;
        } else {
          grid.set(i, j);
        }
      }
    }
  }
  return grid;
}

std::size_t verticesOf(const geometry::PolygonSet& polygons)
{
  return polygons.vertices.size();
}

/// Runs a number of random grids through all radii and tolerances in turn.
void checkMany(unsigned grids, int smallest, int largest, std::uint32_t seed)
{
  constexpr std::size_t kCorners = 4;  // of a cell
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> side(smallest, largest);
  std::size_t vertices = 0;
  std::size_t vertices_of_douglas_peucker = 0;
  geometry::PolygonSet polygons;
  occupancy::BinaryGrid inflated;
  for (unsigned n = 0; n < grids; ++n) {
    const Setting setting{kRadii[n % std::size(kRadii)],
                          kTolerances[n / std::size(kRadii) % std::size(kTolerances)],
                          n % 7 == 0 ? 0.1 : 0.05};
    const occupancy::BinaryGrid grid =
        reference::randomGrid(random(), side(random), side(random), setting.resolution, random);
    thisPackage(grid, setting, polygons, inflated);
    const auto fault =
        reference::PolygonChecker(grid, polygons, setting.radiusInCells(), setting.limitInCells()).fault();
    if (fault) {
      const occupancy::BinaryGrid small = shrunk(thisPackage, grid, setting);
      FAIL() << "grid " << n << ", radius " << 0.001 * setting.radius << " and tolerance "
             << 0.001 * setting.tolerance << " cells: " << *fault
             << "\nshrunk: " << *faultOf(thisPackage, small, setting) << "\n"
             << reference::toText(small);
    }
    vertices += verticesOf(polygons);
    vertices_of_douglas_peucker +=
        reference::verticesOfDouglasPeucker(inflated, setting.tolerance * 0.001, kCorners);
  }
  EXPECT_LE(static_cast<double>(vertices), 1.2 * static_cast<double>(vertices_of_douglas_peucker));
}

TEST(RandomPolygons, KeepTheContractOn100000SmallGrids)
{
  checkMany(100000, 1, 16, 1);
}

TEST(RandomPolygons, KeepTheContractOnLargerGrids)
{
  checkMany(1200, 20, 40, 2);
}

TEST(RandomPolygons, KeepTheContractOnFullSizedGrids)
{
  checkMany(48, 90, 110, 3);
}

TEST(RandomPolygons, OfThePapersKindAreRejected)
{
  std::mt19937 random(4);
  int rejected = 0;
  int tried = 0;
  for (unsigned n = 0; n < 200; ++n) {
    const Setting setting{kRadii[n % 6], kTolerances[n % 4], 0.05};
    const occupancy::BinaryGrid grid = reference::randomGrid(random(), 24, 24, setting.resolution, random);
    if (grid.count() == 0) continue;
    ++tried;
    rejected += faultOf(paper, grid, setting) ? 1 : 0;
  }
  EXPECT_EQ(rejected, tried);
}

}  // namespace
}  // namespace polygonal_perception::test

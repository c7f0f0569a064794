#include <gtest/gtest.h>

#include "reference/error_statistics.hpp"
#include "reference/hausdorff.hpp"
#include "reference/still_view.hpp"

namespace polygonal_perception::test {
namespace {

void addSquare(double x, double y, double side, geometry::PolygonSet& polygons)
{
  polygons.rings.push_back({static_cast<std::uint32_t>(polygons.vertices.size()), 4, false});
  polygons.vertices.insert(polygons.vertices.end(),
                           {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}});
}

geometry::PolygonSet square(double x, double y, double side)
{
  geometry::PolygonSet polygons;
  addSquare(x, y, side, polygons);
  return polygons;
}

TEST(HausdorffDistance, OfMovedOutlineIsHowFarItMoved)
{
  EXPECT_DOUBLE_EQ(reference::hausdorffDistance(square(0, 0, 1), square(0, 0, 1)), 0.0);
  EXPECT_DOUBLE_EQ(reference::hausdorffDistance(square(0, 0, 1), square(0.25, 0, 1)), 0.25);
}

TEST(HausdorffDistance, CountsWhatOnlyOneOfThemHas)
{
  geometry::PolygonSet two = square(0, 0, 1);
  addSquare(3, 0, 1, two);
  EXPECT_DOUBLE_EQ(reference::hausdorffDistance(square(0, 0, 1), two), 3.0);
  EXPECT_DOUBLE_EQ(reference::hausdorffDistance(two, square(0, 0, 1)), 3.0);
  EXPECT_TRUE(std::isinf(reference::hausdorffDistance(two, geometry::PolygonSet{})));
  EXPECT_DOUBLE_EQ(reference::hausdorffDistance(geometry::PolygonSet{}, geometry::PolygonSet{}), 0.0);
}

/// How far the polygons move from frame to frame of still views [m].
std::vector<double> movesOf(const std::string& scene, int min_points_per_cell)
{
  constexpr int kFrames = 12;
  perception::Pipeline::Parameters parameters;
  parameters.projection.min_points_per_cell = min_points_per_cell;
  std::vector<double> moves;
  for (const std::uint64_t seed : {1, 2, 3}) {
    reference::StillView view(scene, seed);
    perception::Pipeline pipeline(parameters);
    geometry::PolygonSet last = pipeline.process(view.frame(0)).polygons;
    for (std::uint32_t k = 1; k < kFrames; ++k) {
      const geometry::PolygonSet& polygons = pipeline.process(view.frame(k)).polygons;
      moves.push_back(reference::hausdorffDistance(last, polygons));
      last = polygons;
    }
  }
  return moves;
}

// Measured: doc/polygons.md. Single cells that come and go are rare, so that the median does not see them.
TEST(SteadyPolygons, HardlyMoveUnderTheSensorsNoise)
{
  for (const std::string scene : {"office", "busy_office", "doorway"})
    EXPECT_LT(reference::quantile(movesOf(scene, 1), 0.5), 0.2) << scene;
}

TEST(SteadyPolygons, ComeAndGoLessWhenCellsNeedThreePoints)
{
  EXPECT_GT(reference::quantile(movesOf("busy_office", 1), 0.95), 1.0);
  EXPECT_LT(reference::quantile(movesOf("busy_office", 3), 0.95), 0.6);
}

}  // namespace
}  // namespace polygonal_perception::test

#include <gtest/gtest.h>

#include <limits>

#include "polygonal_perception/perception/floor/floor_frame.hpp"
#include "polygonal_perception/perception/grid/drop_offs.hpp"
#include "support/plane_scene.hpp"

namespace polygonal_perception::perception {
namespace {

/// A camera 0.8 m above a floor that ends 2 m ahead, seen level so that depth is distance ahead.
class DropOffsTest : public ::testing::Test
{
protected:
  occupancy::BinaryGrid mark(double drop_height, double depth_of_drop)
  {
    test::PlaneScene scene(320, 240, 200.0);
    scene.add(test::raised(floor_, -depth_of_drop));
    scene.add(floor_, [](const Eigen::Vector3d& p) { return p.z() < 2.0; });
    occupancy::BinaryGrid grid{occupancy::GridGeometry{occupancy::GridParameters{}}};
    DropOffs({drop_height}).mark(scene.view(), floorFrame(floor_, ViewAxes{}), grid);
    return grid;
  }

  geometry::Plane floor_ = test::floorSeenFrom(0.8, 0.0);
};

TEST_F(DropOffsTest, BarTheWayBeyondTheEdge)
{
  const occupancy::BinaryGrid grid = mark(0.15, 0.5);
  // Cell 40 begins 2 m ahead; the middle row is straight ahead.
  for (int j = 40; j < 60; ++j) {
    int first = 0;
    while (first < grid.cellsX() && !grid.occupied(first, j)) ++first;
    EXPECT_GE(first, 40) << "row " << j << ": floor was marked";
    EXPECT_LE(first, 42) << "row " << j << ": the edge was not marked";
  }
}

TEST_F(DropOffsTest, AreOffByDefault)
{
  EXPECT_EQ(DropOffs::Parameters{}.drop_height, 0.0);
  EXPECT_EQ(mark(0.0, 0.5).count(), 0U);
}

TEST_F(DropOffsTest, AStepThatIsLowerThanAskedForIsNone)
{
  EXPECT_EQ(mark(0.6, 0.5).count(), 0U);
}

TEST_F(DropOffsTest, PixelsWithoutReturnAreNone)
{
  test::PlaneScene nothing;
  nothing.depth()[200] = -std::numeric_limits<float>::infinity();
  occupancy::BinaryGrid grid{occupancy::GridGeometry{occupancy::GridParameters{}}};
  DropOffs({0.1}).mark(nothing.view(), floorFrame(floor_, ViewAxes{}), grid);
  EXPECT_EQ(grid.count(), 0U);
}

}  // namespace
}  // namespace polygonal_perception::perception

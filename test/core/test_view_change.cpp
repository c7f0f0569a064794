#include <gtest/gtest.h>

#include "plane_scene.hpp"
#include "polygonal_perception/view_change.hpp"

namespace polygonal_perception {
namespace {

SampleGrid gridOf(const Plane& plane)
{
  PlaneScene scene;
  scene.add(plane);
  SampleGrid grid{SampleGrid::Parameters{}};
  grid.update(scene.view());
  return grid;
}

TEST(ViewChange, TheFirstFrameIsNone)
{
  EXPECT_FALSE(ViewChange().update(gridOf(floorSeenFrom(0.8, 0.5))));
}

TEST(ViewChange, ACameraThatMovesSteadilySeesNone)
{
  ViewChange change;
  for (double height = 0.8; height < 1.2; height += 0.05) {
    EXPECT_FALSE(change.update(gridOf(floorSeenFrom(height, 0.5)))) << "at " << height;
  }
}

TEST(ViewChange, ACameraThatIsElsewhereAtOnceSeesOne)
{
  ViewChange change;
  change.update(gridOf(floorSeenFrom(0.8, 0.5)));
  EXPECT_TRUE(change.update(gridOf(floorSeenFrom(1.5, 0.5))));
  EXPECT_FALSE(change.update(gridOf(floorSeenFrom(1.5, 0.5))));
}

TEST(ViewChange, ACoveredCameraIsNone)
{
  ViewChange change;
  change.update(gridOf(floorSeenFrom(0.8, 0.5)));
  SampleGrid nothing{SampleGrid::Parameters{}};
  nothing.update(PlaneScene().view());
  EXPECT_FALSE(change.update(nothing));
}

}  // namespace
}  // namespace polygonal_perception

#include <gtest/gtest.h>

#include "polygonal_perception/perception/floor/view_change.hpp"
#include "support/plane_scene.hpp"

namespace polygonal_perception::perception {
namespace {

SampleGrid gridOf(const geometry::Plane& plane)
{
  test::PlaneScene scene;
  scene.add(plane);
  SampleGrid grid{SampleGrid::Parameters{}};
  grid.update(scene.view());
  return grid;
}

TEST(ViewChange, TheFirstFrameIsNone)
{
  EXPECT_FALSE(ViewChange().update(gridOf(test::floorSeenFrom(0.8, 0.5)), {}));
}

TEST(ViewChange, ACameraThatMovesSteadilySeesNone)
{
  ViewChange change;
  for (double height = 0.8; height < 1.2; height += 0.05) {
    EXPECT_FALSE(change.update(gridOf(test::floorSeenFrom(height, 0.5)), {})) << "at " << height;
  }
}

TEST(ViewChange, ACameraThatIsElsewhereAtOnceSeesOne)
{
  ViewChange change;
  change.update(gridOf(test::floorSeenFrom(0.8, 0.5)), {});
  EXPECT_TRUE(change.update(gridOf(test::floorSeenFrom(1.5, 0.5)), {}));
  EXPECT_FALSE(change.update(gridOf(test::floorSeenFrom(1.5, 0.5)), {}));
}

TEST(ViewChange, ACoveredCameraIsNone)
{
  ViewChange change;
  change.update(gridOf(test::floorSeenFrom(0.8, 0.5)), {});
  SampleGrid nothing{SampleGrid::Parameters{}};
  nothing.update(test::PlaneScene().view());
  EXPECT_FALSE(change.update(nothing, {}));
}

}  // namespace
}  // namespace polygonal_perception::perception

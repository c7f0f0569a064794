#include <gtest/gtest.h>

#include <cmath>

#include "polygonal_perception/cameras/simulation/ray_caster.hpp"
#include "polygonal_perception/cameras/simulation/trajectory.hpp"

namespace polygonal_perception::simulation {
namespace {

Scene floorOnly()
{
  Scene scene;
  Solid floor = makeLevelRectangle({-50, -50}, {50, 50}, 0.0);
  floor.surface = Surface::kFloor;
  scene.solids.push_back(floor);
  return scene;
}

TEST(RayCaster, LookingStraightDownSeesTheFloorAtTheCamerasHeight)
{
  const Scene scene = floorOnly();
  RayCaster caster(scene);
  RayImage image;
  caster.cast(PinholeCamera{}, opticalPose({0, 0, 1.25}, 0.0, M_PI / 2, 0.0), 0.0, image);
  ASSERT_EQ(image.depth.size(), 640U * 480U);
  for (std::size_t i = 0; i < image.depth.size(); ++i) {
    ASSERT_NEAR(image.depth[i], 1.25F, 1e-5F) << "pixel " << i;
    ASSERT_EQ(image.surface[i], Surface::kFloor);
  }
}

TEST(RayCaster, PlateEndsBetweenTheTwoPixelsThatItsEdgeProjectsTo)
{
  Scene scene;
  // A plate 2 m ahead; its left edge, 0.1017 m to the right of the axis, projects to 319.5 + 570.3 * 0.05085
  // = 348.5.
  scene.solids.push_back(
      makeBox(Eigen::Isometry3d(Eigen::Translation3d(2.0005, -0.6017, 1.0)), {0.001, 1.0, 4.0}));
  RayCaster caster(scene);
  RayImage image;
  caster.cast(PinholeCamera{}, opticalPose({0, 0, 1.0}, 0.0, 0.0, 0.0), 0.0, image);
  const std::size_t row = std::size_t{240} * 640;
  EXPECT_TRUE(std::isnan(image.depth[row + 348]));
  EXPECT_EQ(image.surface[row + 348], Surface::kNone);
  EXPECT_NEAR(image.depth[row + 349], 2.0F, 1e-5F);
  EXPECT_EQ(image.surface[row + 349], Surface::kObstacle);
}

TEST(RayCaster, CosineIsThatOfTheRayOnTheSurface)
{
  const Scene scene = floorOnly();
  RayCaster caster(scene);
  RayImage image;
  PinholeCamera one_pixel;
  one_pixel.width = one_pixel.height = 1;
  one_pixel.cx = one_pixel.cy = 0.0;
  caster.cast(one_pixel, opticalPose({0, 0, 1.0}, 0.3, 0.5, 0.1), 0.0, image);
  EXPECT_NEAR(image.cosine[0], std::sin(0.5), 1e-6);
  EXPECT_NEAR(image.depth[0], 1.0 / std::sin(0.5), 1e-5);
}

TEST(RayCaster, EverySizeIsFilledToItsBorders)
{
  const Scene scene = floorOnly();
  RayCaster caster(scene);
  RayImage image;
  for (const auto& size :
       {std::array<std::uint32_t, 2>{1, 1}, {7, 3}, {160, 120}, {161, 121}, {1920, 1080}}) {
    caster.cast(PinholeCamera::ofSize(size[0], size[1]), opticalPose({0, 0, 1.0}, 0.0, M_PI / 2, 0.0), 0.0,
                image);
    ASSERT_EQ(image.depth.size(), std::size_t{size[0]} * size[1]);
    for (const float z : image.depth) ASSERT_NEAR(z, 1.0F, 1e-5F) << size[0] << 'x' << size[1];
  }
}

TEST(RayCaster, PeopleMoveWithTime)
{
  Scene scene = floorOnly();
  scene.walkers.push_back({{3.0, -2.0}, {3.0, 2.0}, 1.0, 0.0, 1.8});
  RayCaster caster(scene);
  const auto nearest = [&](double time) {
    RayImage image;
    PinholeCamera one_pixel;
    one_pixel.width = one_pixel.height = 1;
    one_pixel.cx = one_pixel.cy = 0.0;
    // At the height of the chest.
    caster.cast(one_pixel, opticalPose({0, 0, 1.25}, 0.0, 0.0, 0.0), time, image);
    return image.depth[0];
  };
  EXPECT_TRUE(std::isnan(nearest(0.0)));
  EXPECT_NEAR(nearest(2.0), 2.8F, 0.1F) << "after 2 s at 1 m/s it stands before the camera";
  EXPECT_TRUE(std::isnan(nearest(4.0)));
}

TEST(RayCaster, AnEmptySceneHasNoReturns)
{
  const Scene nothing;
  RayCaster caster(nothing);
  RayImage image;
  caster.cast(PinholeCamera::ofSize(32, 24), Eigen::Isometry3d::Identity(), 0.0, image);
  for (const float z : image.depth) EXPECT_TRUE(std::isnan(z));
}

}  // namespace
}  // namespace polygonal_perception::simulation

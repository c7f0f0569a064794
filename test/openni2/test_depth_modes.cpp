#include <gtest/gtest.h>

#include "cameras/openni2/depth_modes.hpp"

namespace polygonal_perception::openni2 {
namespace {

void expectMode(int number, int width, int height, int rate)
{
  SourceOptions options;
  ASSERT_TRUE(setDepthMode(number, options)) << number;
  EXPECT_EQ(options.width, width) << number;
  EXPECT_EQ(options.height, height) << number;
  EXPECT_EQ(options.rate, rate) << number;
}

TEST(DepthModes, AreNumberedAsInOpenni2Camera)
{
  expectMode(1, 1280, 1024, 30);
  expectMode(4, 1280, 720, 15);
  expectMode(5, 640, 480, 30);
  expectMode(8, 320, 240, 30);
  expectMode(12, 160, 120, 60);
}

TEST(DepthModes, NoOtherNumberChangesAnything)
{
  for (const int number : {-1, 0, 13}) {
    SourceOptions options;
    options.width = 1;
    EXPECT_FALSE(setDepthMode(number, options)) << number;
    EXPECT_EQ(options.width, 1) << number;
  }
}

}  // namespace
}  // namespace polygonal_perception::openni2

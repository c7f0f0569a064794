#include <gtest/gtest.h>

#include "rviz/polygon_colors.hpp"

namespace polygonal_perception::displays {
namespace {

TEST(PolygonColors, PolygonsOfAMessageDiffer)
{
  PolygonColors colors;
  const std::vector<float> hues = colors.assign({{0, 0}, {1, 0}, {2, 0}, {3, 0}});
  ASSERT_EQ(hues.size(), 4U);
  for (std::size_t i = 0; i < hues.size(); ++i) {
    EXPECT_GE(hues[i], 0.0F);
    EXPECT_LE(hues[i], 1.0F);
    for (std::size_t k = 0; k < i; ++k) EXPECT_GT(std::abs(hues[i] - hues[k]), 0.05F) << i << " and " << k;
  }
}

TEST(PolygonColors, APolygonThatMovesALittleKeepsItsHueInAnyOrder)
{
  PolygonColors colors;
  const std::vector<float> before = colors.assign({{0, 0}, {1, 0}});
  const std::vector<float> after = colors.assign({{1.05, 0.02}, {5, 5}, {0.1, 0}});
  ASSERT_EQ(after.size(), 3U);
  EXPECT_EQ(after[0], before[1]);
  EXPECT_EQ(after[2], before[0]);
  EXPECT_NE(after[1], before[0]);
  EXPECT_NE(after[1], before[1]);
}

TEST(PolygonColors, TwoPolygonsDoNotShareTheHueOfOneBefore)
{
  PolygonColors colors;
  colors.assign({{0, 0}});
  const std::vector<float> hues = colors.assign({{0.1, 0}, {-0.1, 0}});
  EXPECT_NE(hues[0], hues[1]);
}

TEST(PolygonColors, TheHueOfAPolygonThatIsGoneIsGivenAgain)
{
  PolygonColors colors;
  const std::vector<float> first = colors.assign({{0, 0}, {1, 0}});
  const std::vector<float> second = colors.assign({{1, 0}, {9, 9}});
  EXPECT_EQ(second[0], first[1]);
  EXPECT_EQ(second[1], first[0]);
}

}  // namespace
}  // namespace polygonal_perception::displays

#include <gtest/gtest.h>

#include "polygonal_perception/geometry/polygon_set.hpp"

namespace polygonal_perception::geometry {
namespace {

const std::vector<Eigen::Vector2d> kTriangle = {{0, 0}, {2, 0}, {0, 1}};

TEST(RingView, ItsEdgesGoRoundOnce)
{
  const RingView ring(kTriangle);
  std::vector<Eigen::Vector2d> from, to;
  for (const auto [a, b] : ring.edges()) {
    from.push_back(a);
    to.push_back(b);
  }
  EXPECT_EQ(from, kTriangle);
  EXPECT_EQ(to, (std::vector<Eigen::Vector2d>{{2, 0}, {0, 1}, {0, 0}}));
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(ring.edge(k).from, from[k]) << k;
    EXPECT_EQ(ring.edge(k).to, to[k]) << k;
  }
}

TEST(RingView, NeighboursOfAVertex)
{
  const RingView ring(kTriangle);
  EXPECT_EQ(ring.next(0), 1U);
  EXPECT_EQ(ring.next(2), 0U);
  EXPECT_EQ(ring.previous(0), 2U);
  EXPECT_EQ(ring.previous(2), 1U);
}

TEST(RingView, WithoutVerticesOrWithOne)
{
  const std::vector<Eigen::Vector2d> none;
  for (const auto [a, b] : RingView(none).edges()) ADD_FAILURE() << a.transpose() << ", " << b.transpose();
  EXPECT_TRUE(RingView(none).empty());
  const std::vector<Eigen::Vector2d> one = {{3, 4}};
  std::size_t count = 0;
  for (const auto [a, b] : RingView(one).edges()) {
    EXPECT_EQ(a, b);
    ++count;
  }
  EXPECT_EQ(count, 1U);
}

TEST(PolygonSet, ShowsEachOfItsRings)
{
  PolygonSet polygons;
  polygons.append(kTriangle, false);
  polygons.append(std::vector<Eigen::Vector2d>{{0.2, 0.2}, {0.2, 0.4}, {0.4, 0.2}, {0.3, 0.1}}, true);
  ASSERT_EQ(polygons.rings.size(), 2U);
  EXPECT_FALSE(polygons.rings[0].hole);
  EXPECT_TRUE(polygons.rings[1].hole);
  const RingView hole = polygons.view(polygons.rings[1]);
  ASSERT_EQ(hole.size(), 4U);
  EXPECT_EQ(hole[3], Eigen::Vector2d(0.3, 0.1));
  EXPECT_EQ(hole.edge(3).to, Eigen::Vector2d(0.2, 0.2));
}

}  // namespace
}  // namespace polygonal_perception::geometry

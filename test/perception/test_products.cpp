#include <gtest/gtest.h>

#include "polygonal_perception/perception/products.hpp"

namespace polygonal_perception::perception {
namespace {

TEST(Products, BringAllThatTheyAreMadeOf)
{
  const Products polygons = Product::kPolygons;
  for (const Product part :
       {Product::kPolygons, Product::kInflation, Product::kOccupancy, Product::kGround, Product::kFloor}) {
    EXPECT_TRUE(polygons.has(part)) << "product " << static_cast<int>(part);
  }
  for (const Product other : {Product::kObserved, Product::kObstaclePoints, Product::kFloorHull,
                              Product::kSampleLabels, Product::kPlanes}) {
    EXPECT_FALSE(polygons.has(other)) << "product " << static_cast<int>(other);
  }
  EXPECT_TRUE(Products(Product::kFloorHull).has(Product::kSampleLabels));
  EXPECT_TRUE(Products(Product::kLookedThrough).has(Product::kObserved));
  EXPECT_TRUE(Products(Product::kObserved).has(Product::kOccupancy));
}

TEST(Products, AreSets)
{
  EXPECT_TRUE(Products{}.empty());
  const Products both = Products(Product::kFloorHull) | Product::kOccupancy;
  EXPECT_EQ(both, (Products{Product::kOccupancy, Product::kFloorHull}));
  EXPECT_EQ(both.withoutOutputFrame(), Products(Product::kFloorHull));
  EXPECT_EQ((Products{Product::kPolygons, Product::kPlanes}.withoutOutputFrame()),
            Products(Product::kPlanes));
  EXPECT_NE(both, Products(Product::kFloorHull));
}

}  // namespace
}  // namespace polygonal_perception::perception

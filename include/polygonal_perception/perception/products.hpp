#pragma once

#include <cstdint>
#include <initializer_list>

namespace polygonal_perception::perception {

/// What a frame can be asked for. A new product is a line here, and one each in Products::needs() and
/// isInOutputFrame(), of which the compiler reminds; a member of Pipeline::Result, and a stage in
/// pipeline.cpp.
enum class Product : std::uint8_t
{
  kFloor,           ///< the plane, its status, and the floor frame
  kSampleLabels,    ///< what became of each sample (figure 3 of the paper)
  kFloorHull,       ///< the convex hull of the floor's samples
  kPlanes,          ///< all planes, with outlines and ids
  kGround,          ///< what heights count from beside the floor
  kOccupancy,       ///< the cells in which something stands
  kObserved,        ///< where the floor was seen, and at which heights something stands
  kLookedThrough,   ///< which heights of each cell the camera looked through
  kScan,            ///< what a level laser would see
  kObstaclePoints,  ///< the points that stand in them
  kInflation,       ///< the cells within robot_radius of those
  kPolygons         ///< the obstacles as polygons
};

/// A set of products, each with all that it is made of: who asks for polygons gets the grids, too.
class Products
{
public:
  constexpr Products() = default;
  // Implicit, so that one product is asked for as it is.
  constexpr Products(Product product) : bits_(bit(product))  // NOLINT(google-explicit-constructor)
  {
    // The floor is made of nothing else.
    if (product != Product::kFloor) bits_ |= needs(product).bits_;
  }
  constexpr Products(std::initializer_list<Product> products)
  {
    for (const Product product : products) *this |= product;
  }

  constexpr bool has(Product product) const { return (bits_ & bit(product)) != 0; }
  constexpr bool empty() const { return bits_ == 0; }

  constexpr Products& operator|=(Products other)
  {
    bits_ |= other.bits_;
    return *this;
  }
  friend constexpr Products operator|(Products a, Products b) { return a |= b; }
  /// Those that are given in the input's or the floor frame: what is left where nobody knows where those lie in the
  /// output frame.
  constexpr Products withoutOutputFrame() const
  {
    Products left;
    for (unsigned k = 0; bits_ >> k != 0; ++k) {
      const auto product = static_cast<Product>(k);
      if (has(product) && !isInOutputFrame(product)) left |= product;
    }
    return left;
  }
  constexpr bool operator==(Products other) const { return bits_ == other.bits_; }
  constexpr bool operator!=(Products other) const { return bits_ != other.bits_; }

private:
  static constexpr std::uint32_t bit(Product product) { return 1U << static_cast<unsigned>(product); }

  /// What a product is made of.
  static constexpr Products needs(Product product)
  {
    switch (product) {
      case Product::kPolygons:
        return Product::kInflation;
      case Product::kInflation:
      case Product::kObserved:
        return Product::kOccupancy;
      case Product::kLookedThrough:
      case Product::kScan:
        return Product::kObserved;
      case Product::kOccupancy:
      case Product::kObstaclePoints:
        return Product::kGround;
      case Product::kFloorHull:
        return Product::kSampleLabels;
      case Product::kFloor:
      case Product::kSampleLabels:
      case Product::kPlanes:
      case Product::kGround:
        break;
    }
    return Product::kFloor;
  }

  static constexpr bool isInOutputFrame(Product product)
  {
    switch (product) {
      case Product::kFloor:
      case Product::kSampleLabels:
      case Product::kFloorHull:
      case Product::kPlanes:
      case Product::kScan:
        return false;
      case Product::kGround:
      case Product::kOccupancy:
      case Product::kObserved:
      case Product::kLookedThrough:
      case Product::kObstaclePoints:
      case Product::kInflation:
      case Product::kPolygons:
        break;
    }
    return true;
  }

  std::uint32_t bits_ = 0;
};

}  // namespace polygonal_perception::perception

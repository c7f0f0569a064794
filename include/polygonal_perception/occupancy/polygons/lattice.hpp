#pragma once

#include <cstdint>

namespace polygonal_perception::occupancy {

/// Outlines have whole coordinates, in 64ths of a cell, so that every test of them is exact. The largest grid
/// that the parameters allow, 10000 x 10000 cells, keeps its products of two coordinates within 64 bits.
constexpr std::int32_t kUnitsPerCell = 64;

struct LatticePoint
{
  std::int32_t x = 0;
  std::int32_t y = 0;
};

inline bool operator==(LatticePoint a, LatticePoint b)
{
  return a.x == b.x && a.y == b.y;
}

/// Twice the area of the triangle, positive when a, b, c run counter-clockwise.
inline std::int64_t cross(LatticePoint a, LatticePoint b, LatticePoint c)
{
  return static_cast<std::int64_t>(b.x - a.x) * (c.y - a.y) -
         static_cast<std::int64_t>(b.y - a.y) * (c.x - a.x);
}

/// The scalar product of a -> b and a -> c.
inline std::int64_t dot(LatticePoint a, LatticePoint b, LatticePoint c)
{
  return static_cast<std::int64_t>(b.x - a.x) * (c.x - a.x) +
         static_cast<std::int64_t>(b.y - a.y) * (c.y - a.y);
}

}  // namespace polygonal_perception::occupancy

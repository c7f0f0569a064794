#include "reference/hausdorff.hpp"

#include <algorithm>
#include <cmath>

#include "polygonal_perception/geometry/distance.hpp"

namespace polygonal_perception::reference {

namespace {

double farthestOf(const geometry::PolygonSet& from, const geometry::PolygonSet& to, double step)
{
  double farthest = 0.0;
  for (const geometry::PolygonSet::Ring& ring : from.rings) {
    for (const auto [a, b] : from.view(ring).edges()) {
      const int count = std::max(1, static_cast<int>(std::ceil((b - a).norm() / step)));
      for (int n = 0; n < count; ++n) {
        const double share = static_cast<double>(n) / count;
        farthest = std::max(farthest, geometry::distanceToBoundary(a + share * (b - a), to));
      }
    }
  }
  return farthest;
}

}  // namespace

double hausdorffDistance(const geometry::PolygonSet& a, const geometry::PolygonSet& b, double step)
{
  return std::max(farthestOf(a, b, step), farthestOf(b, a, step));
}

}  // namespace polygonal_perception::reference

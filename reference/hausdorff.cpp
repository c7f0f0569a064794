#include "reference/hausdorff.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polygonal_perception::reference {

namespace {

template <class Visitor>
void forEachEdge(const geometry::PolygonSet& polygons, Visitor&& visit)
{
  for (const geometry::PolygonSet::Ring& ring : polygons.rings) {
    for (std::uint32_t k = 0; k < ring.size; ++k)
      visit(polygons.vertices[ring.first + k], polygons.vertices[ring.first + (k + 1) % ring.size]);
  }
}

double squaredDistance(const Eigen::Vector2d& point, const geometry::PolygonSet& polygons)
{
  double least = std::numeric_limits<double>::infinity();
  forEachEdge(polygons, [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const Eigen::Vector2d edge = b - a;
    const double along = std::clamp((point - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (point - a - along * edge).squaredNorm());
  });
  return least;
}

double farthestOf(const geometry::PolygonSet& from, const geometry::PolygonSet& to, double step)
{
  double farthest = 0.0;
  forEachEdge(from, [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const int count = std::max(1, static_cast<int>(std::ceil((b - a).norm() / step)));
    for (int n = 0; n < count; ++n) {
      const double share = static_cast<double>(n) / count;
      farthest = std::max(farthest, squaredDistance(a + share * (b - a), to));
    }
  });
  return std::sqrt(farthest);
}

}  // namespace

double hausdorffDistance(const geometry::PolygonSet& a, const geometry::PolygonSet& b, double step)
{
  return std::max(farthestOf(a, b, step), farthestOf(b, a, step));
}

}  // namespace polygonal_perception::reference

#include "occupancy/polygons/vertex_estimate.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "polygonal_perception/geometry/measures.hpp"

namespace polygonal_perception::occupancy {

namespace {

using geometry::cross;

constexpr std::size_t kLeast = 3;

/// The directions of the lines from a point that pass all points after it within the tolerance.
class Sector
{
public:
  explicit Sector(double tolerance) : tolerance_(tolerance) {}

  bool contains(const Eigen::Vector2d& direction) const
  {
    return open_ || (cross(right_, direction) >= 0.0 && cross(direction, left_) >= 0.0);
  }

  /// @param point  seen from the sector's apex
  void narrow(const Eigen::Vector2d& point)
  {
    const double squared_tangent = point.squaredNorm() - tolerance_ * tolerance_;
    if (squared_tangent <= 0.0) return;  // every line passes it
    const Eigen::Vector2d along = std::sqrt(squared_tangent) * point;
    const Eigen::Vector2d across = tolerance_ * Eigen::Vector2d(-point.y(), point.x());
    if (open_ || cross(right_, along - across) > 0.0) right_ = along - across;
    if (open_ || cross(left_, along + across) < 0.0) left_ = along + across;
    open_ = false;
  }

private:
  double tolerance_;
  Eigen::Vector2d right_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d left_ = Eigen::Vector2d::Zero();
  bool open_ = true;  ///< all directions
};

std::size_t estimateVertices(const Outlines& outlines, const Outlines::Ring& ring, double tolerance)
{
  std::size_t count = 1;
  std::uint32_t apex = ring.start;
  std::uint32_t last = apex;
  Sector sector(tolerance);
  for (std::uint32_t n = 0; n < ring.size; ++n) {
    const std::uint32_t vertex = outlines.vertices[last].next;
    const auto from = [&](std::uint32_t seen_from) {
      const LatticePoint a = outlines.vertices[seen_from].at;
      const LatticePoint b = outlines.vertices[vertex].at;
      return Eigen::Vector2d(b.x - a.x, b.y - a.y);
    };
    if (!sector.contains(from(apex))) {
      ++count;
      apex = last;
      sector = Sector(tolerance);
    }
    sector.narrow(from(apex));
    last = vertex;
  }
  return std::max(kLeast, count);
}

}  // namespace

std::size_t estimateVertices(const Outlines& outlines, double tolerance)
{
  std::size_t count = 0;
  for (const Outlines::Ring& ring : outlines.rings)
    count += estimateVertices(outlines, ring, tolerance * kUnitsPerCell);
  return count;
}

}  // namespace polygonal_perception::occupancy

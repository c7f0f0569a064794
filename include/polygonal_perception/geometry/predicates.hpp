#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/ring_view.hpp"

/// Predicates whose answers are those of exact arithmetic on the doubles that go in: no tolerance, no wrong
/// sign. A floating-point filter decides most of them, exact expansions the rest (J. R. Shewchuk, *Adaptive
/// Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates*, 1997).
///
/// Coordinates are finite, and each is 0 or has a magnitude from 1e-100 to 1e100: then nothing overflows or
/// underflows. Doubles are rounded to the nearest, which is the default of every program.
namespace polygonal_perception::geometry {

/// Which way three points turn, with y to the left of x.
enum class Orientation : std::int8_t
{
  kClockwise = -1,
  kCollinear = 0,
  kCounterClockwise = 1
};

/// What orientation() answers, without its filter.
POLYGONAL_PERCEPTION_EXPORT Orientation exactOrientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                                         const Eigen::Vector2d& c);

/// Which way the path from a by b to c turns. Its filter is here so that it can be inlined: a shortest path takes a seventh
/// less time. It holds too where the compiler fuses a product and a sum, which leaves out a rounding.
///
/// @return kCounterClockwise where c lies to the left of the line from a to b, kClockwise to the right,
///         kCollinear on it and where two of the points are the same
inline Orientation orientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
  // Shewchuk's ccwerrboundA: the sum of the products' magnitudes times this bounds the rounding error.
  constexpr double kHalfUlp = 0x1p-53;
  constexpr double kErrorBound = (3.0 + 16.0 * kHalfUlp) * kHalfUlp;

  const double left = (a.x() - c.x()) * (b.y() - c.y());
  const double right = (a.y() - c.y()) * (b.x() - c.x());
  const double determinant = left - right;
  if (std::abs(determinant) > kErrorBound * (std::abs(left) + std::abs(right)))
    return determinant > 0.0 ? Orientation::kCounterClockwise : Orientation::kClockwise;
  return exactOrientation(a, b, c);
}

/// Which way a ring runs as a whole.
///
/// @param ring  at least 3 vertices; of one that meets itself the answer means nothing
/// @return kCollinear only for a ring that meets itself
POLYGONAL_PERCEPTION_EXPORT Orientation orientation(const RingView& ring);

/// Whether p lies on the closed segment from a to b. A segment may be a single point.
POLYGONAL_PERCEPTION_EXPORT bool isOnSegment(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                                             const Eigen::Vector2d& b);

/// What two closed segments have in common.
enum class SegmentContact : std::uint8_t
{
  kNone,     ///< no point
  kTouch,    ///< one point, an end of at least one of them
  kCross,    ///< one point inside both: a proper crossing
  kOverlap,  ///< more than one point: they lie on one line
};

/// What the segments from a to b and from c to d have in common. A segment may be a single point.
POLYGONAL_PERCEPTION_EXPORT SegmentContact segmentContact(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                                          const Eigen::Vector2d& c, const Eigen::Vector2d& d);

/// Whether the closed segments from a to b and from c to d share a point.
POLYGONAL_PERCEPTION_EXPORT bool segmentsIntersect(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                                   const Eigen::Vector2d& c, const Eigen::Vector2d& d);

/// Whether the segments from a to b and from c to d cross properly: in one point inside both.
POLYGONAL_PERCEPTION_EXPORT bool segmentsCross(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                               const Eigen::Vector2d& c, const Eigen::Vector2d& d);

}  // namespace polygonal_perception::geometry

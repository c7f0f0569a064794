#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/polygon_set.hpp"

namespace polygonal_perception::geometry {

/// What a set of polygons is invalid for.
enum class Defect : std::uint8_t
{
  kTooFewVertices,    ///< a ring has fewer than 3
  kNotFinite,         ///< a coordinate is NaN or infinite
  kRepeatedVertex,    ///< a vertex is followed by itself: an edge without a length
  kRingMeetsItself,   ///< a ring crosses or touches itself, or folds back
  kRingsMeet,         ///< two rings of the set cross, touch or share a piece of an edge
  kWrongOrientation,  ///< a boundary runs clockwise or a hole counter-clockwise
  kHoleOutside,       ///< a hole is outside of its boundary, has none before it, or is in another hole
  kPolygonsOverlap    ///< a polygon lies inside of another one, and not in a hole of it
};

/// The reason why a set of polygons is invalid.
struct Invalidity
{
  Defect defect;
  std::uint32_t ring;     ///< index into PolygonSet::rings
  Eigen::Vector2d place;  ///< where to look: a vertex of the ring, or where it meets another edge
  std::string text;       ///< a sentence with the defect, the ring and the place
};

/// Checks that every ring is simple, with at least 3 vertices and its right orientation, that holes lie in
/// their boundaries, and that neither polygons nor their rings overlap or touch. Vertices in a straight line
/// are allowed. Signs are exact, so that the answer does not depend on rounding (within the limits of
/// predicates.hpp).
///
/// The time grows as n log n for n vertices, wherever they lie.
///
/// @return nothing where the set is valid, as one without polygons is; else the first defect that was found,
///         looked for in the order of Defect, and of rings that meet from the left to the right
POLYGONAL_PERCEPTION_EXPORT std::optional<Invalidity> findDefect(const PolygonSet& polygons);

}  // namespace polygonal_perception::geometry

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "polygonal_perception/geometry/validity.hpp"

namespace polygonal_perception::geometry {

/// Looks for rings that lie where they must not: kHoleOutside or kPolygonsOverlap.
/// @param around  of each ring the innermost one around it, or RingSweep::kNone
/// @pre the rings do not meet
std::optional<Invalidity> findWrongNesting(const PolygonSet& polygons,
                                           const std::vector<std::uint32_t>& around);

}  // namespace polygonal_perception::geometry

#pragma once

#include <optional>

#include "polygonal_perception/geometry/validity.hpp"

namespace polygonal_perception::geometry {

enum class ContactOf
{
  kOneRing,
  kTwoRings
};

/// Looks for edges of one ring, or of two, that have a point in common: kRingMeetsItself or kRingsMeet.
/// @pre rings of at least 3 finite vertices, none repeated
std::optional<Invalidity> findContact(const PolygonSet& polygons, ContactOf of);

}  // namespace polygonal_perception::geometry

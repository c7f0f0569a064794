#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mapping/json_document.hpp"

namespace polygonal_perception::mapping {

/// Where a ring is in a file; all indices from 0.
struct RingPlace
{
  std::size_t feature = 0;
  std::optional<std::size_t> polygon;  ///< of a MultiPolygon
  std::size_t ring = 0;

  /// "feature 3, ring 0" or "feature 3, polygon 1, ring 0"
  std::string text() const;
};

std::string featureText(std::size_t feature);

/// Where a value lies that is in these containers, each in the one before it and the last of its values:
/// "feature 3", or with its ring; empty outside of the features.
std::string placeInFeatures(const std::vector<Json*>& containers);

/// Replaces each "ring 7" in a text about a PolygonSet by the place of its ring 7.
std::string withPlaces(const std::string& text, const std::vector<RingPlace>& places);

}  // namespace polygonal_perception::mapping

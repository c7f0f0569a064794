#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mapping/json_document.hpp"
#include "mapping/ring_place.hpp"
#include "polygonal_perception/geometry/polygon_set.hpp"

namespace polygonal_perception::mapping {

/// Takes polygons out of the features of a FeatureCollection. It looks at their form, not at their validity.
class FeatureReader
{
public:
  /// @return what is wrong with the features, or nothing
  std::optional<std::string> read(const Json& features);

  /// What was read, boundaries counter-clockwise and holes clockwise.
  geometry::PolygonSet& polygons() { return polygons_; }

  /// Where each of its rings is in the file.
  const std::vector<RingPlace>& places() const { return places_; }

private:
  std::optional<std::string> readFeature(const Json& feature, std::size_t index);
  std::optional<std::string> readPolygon(const Json& rings, RingPlace place);
  std::optional<std::string> readRing(const Json& positions);
  void append(bool hole);

  geometry::PolygonSet polygons_;
  std::vector<RingPlace> places_;
  std::vector<Eigen::Vector2d> ring_;  // its last position, too
};

}  // namespace polygonal_perception::mapping

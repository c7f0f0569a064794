#include "mapping/feature_reader.hpp"

#include <algorithm>

#include "mapping/number_text.hpp"
#include "polygonal_perception/geometry/predicates.hpp"

namespace polygonal_perception::mapping {

namespace {

std::string pointText(const Eigen::Vector2d& point)
{
  return "(" + shortText(point.x()) + ", " + shortText(point.y()) + ")";
}

std::string typeText(const Json& json)
{
  const Json* const type = findMember(json, "type");
  return type != nullptr ? shown(*type) : json.is_object() ? "an object without a type" : shown(json);
}

/// A position as RFC 7946 has it: an array of two numbers, or more, of which the others are left out.
std::optional<Eigen::Vector2d> toPoint(const Json& position)
{
  if (!position.is_array() || position.size() < 2 || !position[0].is_number() || !position[1].is_number())
    return std::nullopt;
  return Eigen::Vector2d(position[0].get<double>(), position[1].get<double>());
}

}  // namespace

std::optional<std::string> FeatureReader::read(const Json& features)
{
  for (std::size_t index = 0; index < features.size(); ++index) {
    if (auto fault = readFeature(features[index], index)) return featureText(index) + *fault;
  }
  return std::nullopt;
}

/// @return what is wrong, as a text goes on after "feature 3"
std::optional<std::string> FeatureReader::readFeature(const Json& feature, std::size_t index)
{
  const Json* const type = findMember(feature, "type");
  if (type == nullptr || *type != "Feature") return " is " + typeText(feature) + ", accepted is \"Feature\"";
  const Json* const geometry = findMember(feature, "geometry");
  if (geometry == nullptr) return std::string(" has no geometry");
  const Json* const kind = findMember(*geometry, "type");
  const bool multiple = kind != nullptr && *kind == "MultiPolygon";
  if (!multiple && (kind == nullptr || *kind != "Polygon"))
    return " is " + typeText(*geometry) + ", accepted are \"Polygon\" and \"MultiPolygon\"";
  const Json* const coordinates = findMember(*geometry, "coordinates");
  if (coordinates == nullptr || !coordinates->is_array()) return std::string(" has no array of coordinates");
  if (!multiple) return readPolygon(*coordinates, {index, std::nullopt, 0});
  for (std::size_t polygon = 0; polygon < coordinates->size(); ++polygon) {
    if (auto fault = readPolygon((*coordinates)[polygon], {index, polygon, 0}))
      return ", polygon " + std::to_string(polygon) + *fault;
  }
  return std::nullopt;
}

/// @param place  of the polygon's first ring
/// @return what is wrong, as a text goes on after the feature, or the polygon of several
std::optional<std::string> FeatureReader::readPolygon(const Json& rings, RingPlace place)
{
  if (!rings.is_array() || rings.empty()) return std::string(" is no array of rings");
  for (place.ring = 0; place.ring < rings.size(); ++place.ring) {
    if (auto fault = readRing(rings[place.ring])) return ", ring " + std::to_string(place.ring) + *fault;
    append(place.ring > 0);
    places_.push_back(place);
  }
  return std::nullopt;
}

/// @return what is wrong, as a text goes on after the ring
std::optional<std::string> FeatureReader::readRing(const Json& positions)
{
  constexpr std::size_t kFewest = 4;
  if (!positions.is_array()) return " is " + shown(positions) + ", accepted is an array of positions";
  if (positions.size() < kFewest) {
    return " has " + std::to_string(positions.size()) +
           " positions, accepted are at least 4, the last of them the first";
  }
  ring_.clear();
  for (const Json& position : positions) {
    const auto point = toPoint(position);
    if (!point) {
      return ", position " + std::to_string(ring_.size()) + " is no array of two numbers" +
             (ring_.empty() ? "" : ", after " + pointText(ring_.back()));
    }
    ring_.push_back(*point);
  }
  if (ring_.front() == ring_.back()) return std::nullopt;
  return " is not closed: it begins at " + pointText(ring_.front()) + " and ends at " +
         pointText(ring_.back());
}

/// The ring without its repeated position, turned round where it runs the wrong way. Its first vertex stays.
void FeatureReader::append(bool hole)
{
  ring_.pop_back();
  const auto right = hole ? geometry::Orientation::kClockwise : geometry::Orientation::kCounterClockwise;
  if (geometry::orientation(ring_) != right) std::reverse(ring_.begin() + 1, ring_.end());
  polygons_.append(ring_, hole);
}

}  // namespace polygonal_perception::mapping

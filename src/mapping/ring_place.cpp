#include "mapping/ring_place.hpp"

#include <algorithm>

namespace polygonal_perception::mapping {

namespace {

/// Of the first `size` containers the last is the value of that name of the one before it.
bool isMember(const std::vector<Json*>& containers, std::size_t size, const char* name)
{
  return containers.size() >= size && findMember(*containers[size - 2], name) == containers[size - 1];
}

}  // namespace

std::string featureText(std::size_t feature)
{
  return "feature " + std::to_string(feature);
}

std::string RingPlace::text() const
{
  return featureText(feature) + (polygon ? ", polygon " + std::to_string(*polygon) : "") + ", ring " +
         std::to_string(ring);
}

std::string placeInFeatures(const std::vector<Json*>& containers)
{
  // The document, its features, the feature, its geometry, its coordinates, then polygon, ring and position or
  // ring and position.
  constexpr std::size_t kInFeature = 3;
  constexpr std::size_t kInCoordinates = 5;
  constexpr std::size_t kInPositionOfMultiPolygon = 8;
  const auto index_in = [&](std::size_t level) { return containers[level - 1]->size() - 1; };
  if (containers.size() < kInFeature || !isMember(containers, 2, "features")) return {};
  RingPlace place;
  place.feature = index_in(2);
  if (!isMember(containers, 4, "geometry") || !isMember(containers, kInCoordinates, "coordinates"))
    return featureText(place.feature);
  // "type" may come later.
  const Json* const type = findMember(*containers[3], "type");
  const bool multiple =
      (type != nullptr && *type == "MultiPolygon") || containers.size() >= kInPositionOfMultiPolygon;
  const std::size_t in_ring = kInCoordinates + (multiple ? 2 : 1);
  if (containers.size() < in_ring) return featureText(place.feature);
  if (multiple) place.polygon = index_in(kInCoordinates);
  place.ring = index_in(in_ring - 1);
  return place.text();
}

std::string withPlaces(const std::string& text, const std::vector<RingPlace>& places)
{
  const std::string word = "ring ";
  std::string result;
  std::size_t at = 0;
  for (std::size_t found = 0; (found = text.find(word, at)) != std::string::npos;) {
    const std::size_t number = found + word.size();
    const std::size_t end = std::min(text.find_first_not_of("0123456789", number), text.size());
    result += text.substr(at, found - at);
    result += end == number ? word : places.at(std::stoul(text.substr(number, end - number))).text();
    at = end;
  }
  return result + text.substr(at);
}

}  // namespace polygonal_perception::mapping

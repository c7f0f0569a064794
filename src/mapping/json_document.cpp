#include "mapping/json_document.hpp"

#include <utility>

#include "mapping/document_builder.hpp"

namespace polygonal_perception::mapping {

std::variant<JsonDocument, MapFileError> parseJson(const std::string& text, const JsonLimits& limits)
{
  DocumentBuilder builder(text, limits);
  if (!Json::sax_parse(text, &builder)) return MapFileError{builder.error()};
  return std::move(builder.document());
}

const Json* findMember(const Json& json, const char* name)
{
  if (!json.is_object()) return nullptr;
  const auto found = json.find(name);
  return found == json.end() ? nullptr : &*found;
}

std::string shown(const Json& json)
{
  if (json.is_array()) return "an array";
  if (json.is_object()) return "an object";
  constexpr bool kAsciiOnly = true;
  return cut(json.dump(-1, ' ', kAsciiOnly));
}

std::string cut(const std::string& text)
{
  constexpr std::size_t kLongest = 60;
  return text.size() <= kLongest ? text : text.substr(0, kLongest) + "...";
}

}  // namespace polygonal_perception::mapping

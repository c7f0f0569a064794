// A map file of any bytes: refused with a reason, or a good map that stays the same when it is written and read.
#include "mapping/geojson_reader.hpp"
#include "polygonal_perception/mapping/geojson.hpp"
#include "result_check.hpp"
#include "support/same_map.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace polygonal_perception;
  using namespace polygonal_perception::test;
  // Smaller limits than a user's are reached, too, and do not take a second each.
  mapping::JsonLimits limits;
  limits.values = 1000;
  limits.cells = 10'000;
  const auto result = mapping::readLimited(std::string(data, data + size), limits);
  if (const auto* const error = std::get_if<mapping::MapFileError>(&result)) {
    require(!error->text.empty(), "what is refused has a reason");
    for (const char letter : error->text) require(letter >= ' ' && letter <= '~', "a reason is ASCII");
    return 0;
  }
  const auto& map = std::get<mapping::MapFile>(result);
  require(!mapping::findFault(map), "what is read is good");
  const auto text = mapping::writeGeoJson(map);
  const auto* const written = std::get_if<std::string>(&text);
  require(written != nullptr, "what is read can be written");
  const auto again = mapping::readGeoJson(*written);
  const auto* const same = std::get_if<mapping::MapFile>(&again);
  require(same != nullptr, "what is written can be read");
  require(difference(map, *same).empty(), "and is the same");
  return 0;
}

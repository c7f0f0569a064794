#include "polygonal_perception/mapping/occupancy_image.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "mapping/map_faults.hpp"
#include "mapping/number_text.hpp"
#include "mapping/whole_file.hpp"

namespace polygonal_perception::mapping {

namespace {

/// As map_saver does it, with its default thresholds.
char grey(std::int8_t value)
{
  constexpr unsigned char kFree = 254;
  constexpr unsigned char kOccupied = 0;
  constexpr unsigned char kUnknown = 205;
  constexpr int kMostFree = 25;
  constexpr int kLeastOccupied = 65;
  if (value >= kLeastOccupied) return static_cast<char>(kOccupied);
  return static_cast<char>(value >= 0 && value <= kMostFree ? kFree : kUnknown);
}

std::string imageText(int cells_x, int cells_y, double resolution, const std::vector<std::int8_t>& values)
{
  std::string text = "P5\n# CREATOR: polygonal_perception " + fixedText(resolution, 3) + " m/pix\n" +
                     std::to_string(cells_x) + " " + std::to_string(cells_y) + "\n255\n";
  text.reserve(text.size() + values.size());
  for (auto row_end = values.end(); row_end != values.begin(); row_end -= cells_x) {
    for (auto value = row_end - cells_x; value != row_end; ++value) text += grey(*value);
  }
  return text;
}

/// With map_saver's six digits, or with as many as it takes.
std::string numberText(double value)
{
  constexpr int kDigits = 6;
  const std::string text = fixedText(value, kDigits);
  return nlohmann::json::parse(text).get<double>() == value ? text : shortText(value);
}

/// A file name in YAML: as it is, or in quotes where it has characters that mean something there.
std::string nameText(const std::string& name)
{
  const std::string plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._";
  if (name.find_first_not_of(plain + "+-") == std::string::npos && plain.find(name[0]) != std::string::npos)
    return name;
  std::string text = "\"";
  for (const char letter : name) {
    const auto code = static_cast<unsigned char>(letter);
    constexpr unsigned char kFirstPrintable = 0x20;
    constexpr unsigned char kDelete = 0x7f;
    if (code < kFirstPrintable || code == kDelete) {
      char escaped[sizeof "\\x00"];
      std::snprintf(escaped, sizeof escaped, "\\x%02x", code);
      text += escaped;
    } else {
      if (letter == '"' || letter == '\\') text += '\\';
      text += letter;
    }
  }
  return text + "\"";
}

std::string descriptionText(const std::string& image_path, double resolution, double origin_x,
                            double origin_y)
{
  return "image: " + nameText(image_path.substr(image_path.rfind('/') + 1)) +
         "\nresolution: " + numberText(resolution) + "\norigin: [" + numberText(origin_x) + ", " +
         numberText(origin_y) + ", 0.000000]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n\n";
}

}  // namespace

std::optional<MapFileError> writeOccupancyImage(const std::string& path, int cells_x, int cells_y,
                                                double resolution, double origin_x, double origin_y,
                                                const std::vector<std::int8_t>& values)
{
  const std::string image_path = path + ".pgm";
  const std::string description_path = path + ".yaml";
  if (auto fault = findGridFault(cells_x, cells_y, resolution, origin_x, origin_y))
    return writeFailure(image_path, *fault);
  if (values.size() != static_cast<std::size_t>(cells_x) * static_cast<std::size_t>(cells_y)) {
    return writeFailure(image_path, "there are " + std::to_string(values.size()) + " values, accepted are " +
                                        std::to_string(cells_x) + " x " + std::to_string(cells_y));
  }
  PendingFile image(image_path);
  PendingFile description(description_path);
  if (auto error = image.write(imageText(cells_x, cells_y, resolution, values))) return error;
  if (auto error = description.write(descriptionText(image_path, resolution, origin_x, origin_y)))
    return error;
  if (auto error = image.takePlace()) return error;
  return description.takePlace();
}

}  // namespace polygonal_perception::mapping

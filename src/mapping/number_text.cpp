#include "mapping/number_text.hpp"

#include <locale>
#include <nlohmann/json.hpp>
#include <sstream>

namespace polygonal_perception::mapping {

std::string shortText(double value)
{
  // std::to_chars of double came with GCC 11; we are built with GCC 9, too.
  return nlohmann::json(value).dump();
}

std::string fixedText(double value, int digits)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(digits);
  text << std::fixed << value;
  return text.str();
}

}  // namespace polygonal_perception::mapping

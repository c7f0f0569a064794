#pragma once

#include <string>

/// Numbers as text, whatever the locale is.
namespace polygonal_perception::mapping {

/// @param value  finite
/// @return few digits that are read as the same double: "0.3", "-0.0", "1e+100"
std::string shortText(double value);

/// @return as printf's "%.3f" makes it, for 3 digits
std::string fixedText(double value, int digits);

}  // namespace polygonal_perception::mapping

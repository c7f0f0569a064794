#pragma once

#include <optional>
#include <string>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/perception/pipeline.hpp"

namespace polygonal_perception::perception {

/// Why a set of parameters cannot be used, and which of them are to blame.
struct ParameterFault
{
  std::vector<std::string> names;
  std::string reason;  ///< names the parameters, their values and what is accepted
};

/// Checks every parameter against its range, then those that depend on one another.
/// @return the first fault, or nothing where the set is good
POLYGONAL_PERCEPTION_EXPORT std::optional<ParameterFault> findFault(const Pipeline::Parameters& parameters);

/// A number as people write it: "0.3", "1e-06", "32".
POLYGONAL_PERCEPTION_EXPORT std::string numberText(double number);

/// "0.3 to 5 m", as it stands in messages and tables.
POLYGONAL_PERCEPTION_EXPORT std::string rangeText(const parameters::Range& range, const std::string& unit);

}  // namespace polygonal_perception::perception

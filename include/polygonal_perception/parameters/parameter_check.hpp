#pragma once

#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "polygonal_perception/parameters/parameter_table.hpp"

namespace polygonal_perception::parameters {

/// Why a set of parameters cannot be used, and which of them are to blame.
struct ParameterFault
{
  std::vector<std::string> names;
  std::string reason;  ///< names the parameters, their values and what is accepted
};

/// A number as people write it: "0.3", "1e-06", "32".
inline std::string numberText(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

/// "0.3 to 5 m", as it stands in messages and tables.
inline std::string rangeText(const Range& range, const std::string& unit)
{
  return numberText(range.min) + " to " + numberText(range.max) + (unit.empty() ? "" : " " + unit);
}

/// @return the fault of the first number that is out of its range, or nothing; what is no number is not
///         looked at
template <class Parameters>
std::optional<ParameterFault> findOutOfRange(const Parameters& parameters)
{
  std::optional<ParameterFault> fault;
  const auto check = [&fault](const char* name, double number, const Range& range, const char* unit,
                              const char* /*help*/) {
    if (fault || range.contains(number)) return;
    fault = ParameterFault{
        {name}, std::string(name) + " is " + numberText(number) + ", accepted is " + rangeText(range, unit)};
  };
  Parameters::describe(parameters, [&check](const char* name, const auto& value, const auto&... rule) {
    if constexpr (sizeof...(rule) == 3) check(name, static_cast<double>(value), rule...);
  });
  return fault;
}

/// @return why two parameters that must be in order are not, or nothing
inline std::optional<ParameterFault> findDisorder(const char* lower_name, double lower,
                                                  const char* upper_name, double upper)
{
  if (lower < upper) return std::nullopt;
  return ParameterFault{{lower_name, upper_name},
                        std::string(lower_name) + " is " + numberText(lower) + " and " + upper_name + " is " +
                            numberText(upper) + ", accepted is " + lower_name + " < " + upper_name};
}

/// @return why a set of parameters cannot be used: the first that is out of its range, else what its own
///         conflict() says; nothing where the set is good
template <class Parameters>
std::optional<ParameterFault> findFault(const Parameters& parameters)
{
  auto fault = findOutOfRange(parameters);
  return fault ? fault : parameters.conflict();
}

}  // namespace polygonal_perception::parameters

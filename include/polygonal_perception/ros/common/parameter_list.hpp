#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/parameters/frame_box.hpp"
#include "polygonal_perception/parameters/parameter_table.hpp"

namespace polygonal_perception::ros_common {

/// A parameter of a struct with a describe() (parameters/parameter_table.hpp), without the struct's type.
struct ParameterEntry
{
  using Value =
      std::variant<double*, int*, bool*, std::string*, Eigen::Vector3d*, std::optional<Eigen::Vector3d>*,
                   std::vector<parameters::FrameBox>*, std::vector<std::string>*>;

  std::string name;
  Value value;                             ///< the struct's member
  parameters::Range range;                 ///< of a number
  std::string unit;                        ///< of a number
  parameters::TextRule rule{"", nullptr};  ///< of a text
  std::string help;

  bool isNumber() const
  {
    return std::holds_alternative<double*>(value) || std::holds_alternative<int*>(value);
  }
  /// Whether dynamic_reconfigure may change it.
  bool isReconfigurable() const { return isNumber() && !range.at_start; }

  /// Takes on another entry's value; both are entries of the same parameter.
  void copyFrom(const ParameterEntry& other)
  {
    std::visit([&other](auto* to) { *to = *std::get<decltype(to)>(other.value); }, value);
  }
};

/// The parameters of a struct, in the order of its describe(). They point into the struct, which must outlive
/// them.
using ParameterList = std::vector<ParameterEntry>;

template <class Parameters>
ParameterList listParameters(Parameters& parameters)
{
  ParameterList list;
  Parameters::describe(parameters, [&list](const char* name, auto& value, const auto&... rule) {
    ParameterEntry entry{name, &value, {}, {}, {"", nullptr}, {}};
    if constexpr (sizeof...(rule) == 3) {
      const auto set = [&entry](const parameters::Range& range, const char* unit, const char* help) {
        entry.range = range;
        entry.unit = unit;
        entry.help = help;
      };
      set(rule...);
    } else if constexpr (sizeof...(rule) == 2) {
      const auto set = [&entry](const parameters::TextRule& text, const char* help) {
        entry.rule = text;
        entry.help = help;
      };
      set(rule...);
    } else {
      entry.help = (std::string() + ... + rule);
    }
    list.push_back(entry);
  });
  return list;
}

/// The table of a node's parameters in Markdown: name, default, range, unit, meaning.
/// @param defaults  of a struct as it is made
POLYGONAL_PERCEPTION_EXPORT std::string parameterTable(const ParameterList& defaults);

}  // namespace polygonal_perception::ros_common

#include "ros/common/reconfigure_messages.hpp"

#include <map>
#include <type_traits>

namespace polygonal_perception::ros_common {

namespace {

using dynamic_reconfigure::Config;

void append(Config& config, const char* name, int value)
{
  dynamic_reconfigure::IntParameter& parameter = config.ints.emplace_back();
  parameter.name = name;
  parameter.value = value;
}

void append(Config& config, const char* name, double value)
{
  dynamic_reconfigure::DoubleParameter& parameter = config.doubles.emplace_back();
  parameter.name = name;
  parameter.value = value;
}

/// Clients expect a root group, "Default", in every set.
Config emptyConfig()
{
  Config config;
  dynamic_reconfigure::GroupState& group = config.groups.emplace_back();
  group.name = "Default";
  group.state = 1;
  return config;
}

}  // namespace

Config toConfig(const perception::Pipeline::Parameters& parameters)
{
  Config config = emptyConfig();
  perception::Pipeline::Parameters::describe(
      parameters, [&config](const char* name, auto value, const auto&...) { append(config, name, value); });
  return config;
}

dynamic_reconfigure::ConfigDescription describeConfig()
{
  dynamic_reconfigure::ConfigDescription description;
  dynamic_reconfigure::Group& group = description.groups.emplace_back();
  group.name = "Default";
  description.max = description.min = emptyConfig();
  const perception::Pipeline::Parameters defaults;
  description.dflt = toConfig(defaults);
  perception::Pipeline::Parameters::describe(
      defaults, [&](const char* name, auto value, const parameters::Range& range, const std::string& unit,
                    const char* help) {
        using Value = decltype(value);
        dynamic_reconfigure::ParamDescription& parameter = group.parameters.emplace_back();
        parameter.name = name;
        parameter.type = std::is_same_v<Value, int> ? "int" : "double";
        parameter.description = unit.empty() ? help : "[" + unit + "] " + help;
        append(description.min, name, static_cast<Value>(range.min));
        append(description.max, name, static_cast<Value>(range.max));
      });
  return description;
}

std::string mergeConfig(const Config& config, perception::Pipeline::Parameters& parameters)
{
  std::map<std::string, double> doubles;
  std::map<std::string, int> ints;
  for (const auto& parameter : config.doubles) doubles[parameter.name] = parameter.value;
  for (const auto& parameter : config.ints) ints[parameter.name] = parameter.value;

  perception::Pipeline::Parameters::describe(parameters, [&](const char* name, auto& value, const auto&...) {
    const auto take = [&](auto& from) {
      const auto found = from.find(name);
      if (found == from.end()) return;
      value = found->second;
      from.erase(found);
    };
    // A whole number will do for any number.
    take(ints);
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>) take(doubles);
  });
  if (!doubles.empty()) return doubles.begin()->first + " is no parameter, or none that takes a double";
  if (!ints.empty()) return ints.begin()->first + " is no parameter, or none that takes an int";
  if (!config.bools.empty()) return config.bools.front().name + " is no parameter, or none that takes a bool";
  if (!config.strs.empty()) return config.strs.front().name + " is no parameter, or none that takes a string";
  return {};
}

}  // namespace polygonal_perception::ros_common

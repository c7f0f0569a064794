#include "polygonal_perception/ros/common/reconfigure_messages.hpp"

#include <map>

namespace polygonal_perception::ros_common {

namespace {

using dynamic_reconfigure::Config;

void append(Config& config, const std::string& name, int value)
{
  dynamic_reconfigure::IntParameter& parameter = config.ints.emplace_back();
  parameter.name = name;
  parameter.value = value;
}

void append(Config& config, const std::string& name, double value)
{
  dynamic_reconfigure::DoubleParameter& parameter = config.doubles.emplace_back();
  parameter.name = name;
  parameter.value = value;
}

/// Appends one of an entry's numbers, in the entry's type.
void append(Config& config, const ParameterEntry& entry, double number)
{
  if (std::holds_alternative<int*>(entry.value)) {
    append(config, entry.name, static_cast<int>(number));
  } else {
    append(config, entry.name, number);
  }
}

double numberOf(const ParameterEntry& entry)
{
  const auto* const* whole = std::get_if<int*>(&entry.value);
  return whole != nullptr ? **whole : *std::get<double*>(entry.value);
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

/// Moves the value of that name out of a set.
template <class Values, class Number>
void take(Values& from, const std::string& name, Number& to)
{
  const auto found = from.find(name);
  if (found == from.end()) return;
  to = found->second;
  from.erase(found);
}

}  // namespace

Config toConfig(const ParameterList& parameters)
{
  Config config = emptyConfig();
  for (const ParameterEntry& entry : parameters) {
    if (entry.isReconfigurable()) append(config, entry, numberOf(entry));
  }
  return config;
}

dynamic_reconfigure::ConfigDescription describeConfig(const ParameterList& defaults)
{
  dynamic_reconfigure::ConfigDescription description;
  dynamic_reconfigure::Group& group = description.groups.emplace_back();
  group.name = "Default";
  description.max = description.min = emptyConfig();
  description.dflt = toConfig(defaults);
  for (const ParameterEntry& entry : defaults) {
    if (!entry.isReconfigurable()) continue;
    dynamic_reconfigure::ParamDescription& parameter = group.parameters.emplace_back();
    parameter.name = entry.name;
    parameter.type = std::holds_alternative<int*>(entry.value) ? "int" : "double";
    parameter.description = entry.unit.empty() ? entry.help : "[" + entry.unit + "] " + entry.help;
    append(description.min, entry, entry.range.min);
    append(description.max, entry, entry.range.max);
  }
  return description;
}

std::string mergeConfig(const Config& config, const ParameterList& parameters)
{
  std::map<std::string, double> doubles;
  std::map<std::string, int> ints;
  for (const auto& parameter : config.doubles) doubles[parameter.name] = parameter.value;
  for (const auto& parameter : config.ints) ints[parameter.name] = parameter.value;

  for (const ParameterEntry& entry : parameters) {
    if (!entry.isReconfigurable()) continue;
    if (auto* const* whole = std::get_if<int*>(&entry.value)) take(ints, entry.name, **whole);
    if (auto* const* number = std::get_if<double*>(&entry.value)) {
      take(ints, entry.name, **number);  // a whole number will do for any number
      take(doubles, entry.name, **number);
    }
  }
  if (!doubles.empty()) return doubles.begin()->first + " is no parameter, or none that takes a double";
  if (!ints.empty()) return ints.begin()->first + " is no parameter, or none that takes an int";
  if (!config.bools.empty()) return config.bools.front().name + " is no parameter, or none that takes a bool";
  if (!config.strs.empty()) return config.strs.front().name + " is no parameter, or none that takes a string";
  return {};
}

}  // namespace polygonal_perception::ros_common

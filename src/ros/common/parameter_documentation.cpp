#include <sstream>

#include "polygonal_perception/parameters/parameter_check.hpp"
#include "polygonal_perception/ros/common/parameter_list.hpp"

namespace polygonal_perception::ros_common {

using parameters::numberText;

namespace {

struct Type
{
  const char* operator()(const double* /*value*/) const { return "double"; }
  const char* operator()(const int* /*value*/) const { return "int"; }
  const char* operator()(const bool* /*value*/) const { return "bool"; }
  const char* operator()(const std::string* /*value*/) const { return "string"; }
  const char* operator()(const Eigen::Vector3d* /*value*/) const { return "list"; }
  const char* operator()(const std::optional<Eigen::Vector3d>* /*value*/) const { return "list"; }
  const char* operator()(const std::vector<parameters::FrameBox>* /*value*/) const { return "list"; }
  const char* operator()(const std::vector<std::string>* /*value*/) const { return "list"; }
};

struct Text
{
  std::string operator()(const double* value) const { return numberText(*value); }
  std::string operator()(const int* value) const { return numberText(*value); }
  std::string operator()(const bool* value) const { return *value ? "true" : "false"; }
  std::string operator()(const std::string* value) const { return value->empty() ? "(empty)" : *value; }
  std::string operator()(const Eigen::Vector3d* value) const
  {
    return "[" + numberText(value->x()) + ", " + numberText(value->y()) + ", " + numberText(value->z()) + "]";
  }
  std::string operator()(const std::optional<Eigen::Vector3d>* value) const
  {
    return value->has_value() ? (*this)(&**value) : "[]";
  }
  /// Nobody's defaults have one.
  std::string operator()(const std::vector<parameters::FrameBox>* /*value*/) const { return "[]"; }
  std::string operator()(const std::vector<std::string>* /*value*/) const { return "[]"; }
};

std::string acceptedBy(const ParameterEntry& entry)
{
  if (entry.isNumber()) return parameters::rangeText(entry.range, entry.unit);
  if (std::holds_alternative<Eigen::Vector3d*>(entry.value)) return "not zero";
  if (std::holds_alternative<std::optional<Eigen::Vector3d>*>(entry.value)) return "empty or not zero";
  if (std::holds_alternative<std::vector<parameters::FrameBox>*>(entry.value))
    return "[[frame, x, y, z from, x, y, z to], ...]";
  if (std::holds_alternative<std::vector<std::string>*>(entry.value)) return "[name, ...]";
  return entry.rule.accepted;
}

}  // namespace

std::string parameterTable(const ParameterList& defaults)
{
  std::ostringstream table;
  table << "| Parameter | Type | Default | Accepted | Meaning |\n|---|---|---|---|---|\n";
  for (const ParameterEntry& entry : defaults) {
    table << "| `" << entry.name << "` | " << std::visit(Type{}, entry.value) << " | "
          << std::visit(Text{}, entry.value) << " | " << acceptedBy(entry) << " | " << entry.help << " |\n";
  }
  return table.str();
}

}  // namespace polygonal_perception::ros_common

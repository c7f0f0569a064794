#include "polygonal_perception/ros/common/parameter_reader.hpp"

#include <ros/master.h>
#include <ros/param.h>
#include <ros/this_node.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <type_traits>

#include "polygonal_perception/parameters/parameter_check.hpp"
#include "polygonal_perception/ros/common/text_rules.hpp"

namespace polygonal_perception::ros_common {

namespace {

using XmlRpc::XmlRpcValue;

/// Each `take` gives the value's new content, or leaves it alone and returns false where the type does not
/// fit.
bool take(XmlRpcValue& from, std::string& to)
{
  if (from.getType() != XmlRpcValue::TypeString) return false;
  to = static_cast<std::string>(from);
  return true;
}

bool take(XmlRpcValue& from, bool& to)
{
  if (from.getType() != XmlRpcValue::TypeBoolean) return false;
  to = static_cast<bool>(from);
  return true;
}

bool take(XmlRpcValue& from, double& to)
{
  if (from.getType() == XmlRpcValue::TypeInt) {
    to = static_cast<int>(from);
    return true;
  }
  if (from.getType() != XmlRpcValue::TypeDouble) return false;
  to = static_cast<double>(from);
  return true;
}

bool take(XmlRpcValue& from, int& to)
{
  double number = 0.0;
  if (!take(from, number) || number != std::floor(number) || std::abs(number) > 1e9) return false;
  to = static_cast<int>(number);
  return true;
}

bool take(XmlRpcValue& from, Eigen::Vector3d& to)
{
  Eigen::Vector3d vector;
  if (from.getType() != XmlRpcValue::TypeArray || from.size() != vector.size()) return false;
  for (int i = 0; i < vector.size(); ++i) {
    if (!take(from[i], vector[i])) return false;
  }
  if (!(vector.norm() > 0.0) || !vector.allFinite()) return false;
  to = vector;
  return true;
}

bool take(XmlRpcValue& from, std::optional<Eigen::Vector3d>& to)
{
  if (from.getType() == XmlRpcValue::TypeArray && from.size() == 0) {
    to.reset();
    return true;
  }
  Eigen::Vector3d vector;
  if (!take(from, vector)) return false;
  to = vector;
  return true;
}

bool take(XmlRpcValue& from, parameters::FrameBox& to)
{
  constexpr int kAxes = 3;
  if (from.getType() != XmlRpcValue::TypeArray || from.size() != 1 + 2 * kAxes) return false;
  parameters::FrameBox box;
  if (!take(from[0], box.frame) || !isFrame(box.frame)) return false;
  for (int i = 0; i < kAxes; ++i) {
    double& low = box.from[static_cast<std::size_t>(i)];
    double& high = box.to[static_cast<std::size_t>(i)];
    if (!take(from[1 + i], low) || !take(from[1 + kAxes + i], high)) return false;
    if (!std::isfinite(low) || !std::isfinite(high) || low > high) return false;
  }
  to = box;
  return true;
}

bool take(XmlRpcValue& from, std::vector<parameters::FrameBox>& to)
{
  if (from.getType() != XmlRpcValue::TypeArray) return false;
  std::vector<parameters::FrameBox> boxes;
  for (int i = 0; i < from.size(); ++i) {
    if (!take(from[i], boxes.emplace_back())) return false;
  }
  to = boxes;
  return true;
}

bool take(XmlRpcValue& from, std::vector<std::string>& to)
{
  if (from.getType() != XmlRpcValue::TypeArray) return false;
  std::vector<std::string> names;
  for (int i = 0; i < from.size(); ++i) {
    std::string name;
    if (!take(from[i], name) || name.empty() || std::count(names.begin(), names.end(), name) > 0)
      return false;
    names.push_back(name);
  }
  to = names;
  return true;
}

template <class T>
bool isAccepted(const ParameterEntry& entry, const T& value)
{
  if constexpr (std::is_same_v<T, double> || std::is_same_v<T, int>) return entry.range.contains(value);
  if constexpr (std::is_same_v<T, std::string>) return entry.rule.accepts(value);
  return true;
}

struct Accepted
{
  const ParameterEntry& entry;

  std::string operator()(const double* /*value*/) const
  {
    return parameters::rangeText(entry.range, entry.unit);
  }
  std::string operator()(const int* /*value*/) const
  {
    return parameters::rangeText(entry.range, entry.unit) + " (a whole number)";
  }
  std::string operator()(const bool* /*value*/) const { return "true or false"; }
  std::string operator()(const std::string* /*value*/) const { return entry.rule.accepted; }
  std::string operator()(const Eigen::Vector3d* /*value*/) const
  {
    return "a list of three numbers that are not all zero";
  }
  std::string operator()(const std::optional<Eigen::Vector3d>* /*value*/) const
  {
    return "an empty list, or one of three numbers that are not all zero";
  }
  std::string operator()(const std::vector<parameters::FrameBox>* /*value*/) const
  {
    return "a list of lists [frame, x, y, z from, x, y, z to], each from at most its to";
  }
  std::string operator()(const std::vector<std::string>* /*value*/) const
  {
    return "a list of names, none of them twice";
  }
};

/// @return whether the value fits and was taken
bool assign(ParameterEntry& entry, XmlRpcValue& raw)
{
  return std::visit(
      [&](auto* value) {
        auto candidate = *value;
        if (!take(raw, candidate) || !isAccepted(entry, candidate)) return false;
        *value = candidate;
        return true;
      },
      entry.value);
}

std::vector<std::string> unknownNames(const ros::NodeHandle& handle, const ParameterList& parameters,
                                      const std::vector<parameters::RetiredName>& retired)
{
  // Read by the libraries that the node stands on.
  std::set<std::string> known = {"diagnostic_period"};
  for (const ParameterEntry& entry : parameters) known.insert(entry.name);
  for (const parameters::RetiredName& name : retired) known.insert(name.name);
  std::vector<std::string> all;
  std::vector<std::string> unknown;
  const std::string prefix = handle.getNamespace() + "/";
  ros::param::getParamNames(all);
  for (const std::string& full : all) {
    if (full.compare(0, prefix.size(), prefix) != 0) continue;
    const std::string name = full.substr(prefix.size());
    // What lies deeper belongs to image_transport's plugins.
    if (name.find('/') != std::string::npos || known.count(name) > 0) continue;
    unknown.push_back("parameter " + full + " means nothing to this node; is it misspelt?");
  }
  return unknown;
}

}  // namespace

ParameterReport readParameters(const ros::NodeHandle& private_handle, ParameterList& parameters,
                               const std::vector<parameters::RetiredName>& retired)
{
  ParameterReport report;
  for (ParameterEntry& entry : parameters) {
    XmlRpcValue raw;
    if (!private_handle.getParam(entry.name, raw) || assign(entry, raw)) continue;
    std::ostringstream text;
    text << "parameter " << private_handle.resolveName(entry.name) << " is " << raw << ", accepted is "
         << std::visit(Accepted{entry}, entry.value) << "; the default stays";
    report.errors.push_back(text.str());
  }
  for (const parameters::RetiredName& name : retired) {
    if (!private_handle.hasParam(name.name)) continue;
    report.errors.push_back("parameter " + private_handle.resolveName(name.name) +
                            " is refused: there is no such parameter any more, accepted is " + name.instead +
                            ", which means something else (README.md)");
  }
  report.warnings = unknownNames(private_handle, parameters, retired);
  return report;
}

void writeParameters(const ros::NodeHandle& private_handle, const ParameterList& parameters)
{
  // NodeHandle::setParam() waits for a roscore that is gone, and no frame would be answered meanwhile.
  constexpr bool kWaitForMaster = false;
  for (const ParameterEntry& entry : parameters) {
    if (!entry.isReconfigurable()) continue;
    XmlRpcValue request;
    XmlRpcValue response;
    XmlRpcValue payload;
    request[0] = ros::this_node::getName();
    request[1] = private_handle.resolveName(entry.name);
    if (const auto* const* number = std::get_if<double*>(&entry.value)) request[2] = **number;
    if (const auto* const* number = std::get_if<int*>(&entry.value)) request[2] = **number;
    ros::master::execute("setParam", request, response, payload, kWaitForMaster);
  }
}

}  // namespace polygonal_perception::ros_common

#include "ros/perception/node_parameters.hpp"

#include <ros/master.h>
#include <ros/param.h>
#include <ros/this_node.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "polygonal_perception/perception/parameter_check.hpp"

namespace polygonal_perception::ros_perception {

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

/// Reads one parameter after the other, as a visitor of NodeParameters.
class Reader
{
public:
  Reader(const ros::NodeHandle& handle, std::vector<std::string>& errors) : handle_(handle), errors_(errors)
  {
  }

  template <class T>
  void operator()(const char* name, T& value, const parameters::Range& range, const char* unit,
                  const char* /*help*/)
  {
    read(name, value, perception::rangeText(range, unit) + (std::is_integral_v<T> ? " (a whole number)" : ""),
         [&range](T number) { return number >= range.min && number <= range.max; });
  }

  void operator()(const char* name, std::string& value, const TextRule& rule, const char* /*help*/)
  {
    read(name, value, rule.accepted, rule.accepts);
  }

  void operator()(const char* name, bool& value, const char* /*help*/)
  {
    read(name, value, "true or false", [](bool) { return true; });
  }

  void operator()(const char* name, Eigen::Vector3d& value, const char* /*help*/)
  {
    read(name, value, "a list of three numbers that are not all zero",
         [](const Eigen::Vector3d&) { return true; });
  }

  const std::set<std::string>& names() const { return names_; }

private:
  template <class T, class Accepts>
  void read(const std::string& name, T& value, const std::string& accepted, Accepts&& accepts)
  {
    names_.insert(name);
    XmlRpcValue raw;
    if (!handle_.getParam(name, raw)) return;
    T candidate = value;
    if (take(raw, candidate) && accepts(candidate)) {
      value = candidate;
      return;
    }
    std::ostringstream text;
    text << "parameter " << handle_.resolveName(name) << " is " << raw << ", accepted is " << accepted
         << "; the default stays";
    errors_.push_back(text.str());
  }

  const ros::NodeHandle& handle_;
  std::vector<std::string>& errors_;
  std::set<std::string> names_;
};

/// Gives some parameters their defaults back.
class Restorer
{
public:
  explicit Restorer(const std::vector<std::string>& names) : names_(names)
  {
    perception::Pipeline::Parameters::describe(defaults_,
                                               [this](const char* name, auto& value, const auto&...) {
                                                 default_values_[name] = static_cast<double>(value);
                                               });
  }

  template <class T>
  void operator()(const char* name, T& value, const parameters::Range& /*range*/, const char* /*unit*/,
                  const char* /*help*/)
  {
    if (std::find(names_.begin(), names_.end(), name) != names_.end())
      value = static_cast<T>(default_values_.at(name));
  }

private:
  std::vector<std::string> names_;
  const perception::Pipeline::Parameters defaults_;
  std::map<std::string, double> default_values_;
};

std::vector<std::string> unknownNames(const ros::NodeHandle& handle, const std::set<std::string>& known)
{
  // Read by the libraries that the node stands on.
  const std::set<std::string> others = {"diagnostic_period"};
  std::vector<std::string> all;
  std::vector<std::string> unknown;
  const std::string prefix = handle.getNamespace() + "/";
  ros::param::getParamNames(all);
  for (const std::string& full : all) {
    if (full.compare(0, prefix.size(), prefix) != 0) continue;
    const std::string name = full.substr(prefix.size());
    // What lies deeper belongs to image_transport's plugins.
    if (name.find('/') != std::string::npos || known.count(name) + others.count(name) > 0) continue;
    unknown.push_back("parameter " + full + " means nothing to this node; is it misspelt?");
  }
  return unknown;
}

}  // namespace

bool isInputKind(const std::string& text)
{
  return text == "cloud" || text == "depth";
}
bool isFrame(const std::string& text)
{
  return !text.empty() && text.front() != '/';
}
bool isFrameOrEmpty(const std::string& text)
{
  return text.empty() || isFrame(text);
}

NodeParameters readNodeParameters(const ros::NodeHandle& private_handle, std::vector<std::string>& errors,
                                  std::vector<std::string>& warnings)
{
  NodeParameters parameters;
  Reader reader(private_handle, errors);
  NodeParameters::describe(parameters, reader);
  // Each is within its range now; some may still contradict one another.
  while (const auto fault = perception::findFault(parameters.pipeline)) {
    errors.push_back("parameters in " + private_handle.getNamespace() + ": " + fault->reason +
                     "; their defaults stay");
    perception::Pipeline::Parameters::describe(parameters.pipeline, Restorer(fault->names));
  }
  if (parameters.output_frame == parameters.floor_frame) parameters.output_frame.clear();
  warnings = unknownNames(private_handle, reader.names());
  return parameters;
}

void writePipelineParameters(const ros::NodeHandle& private_handle,
                             const perception::Pipeline::Parameters& parameters)
{
  // NodeHandle::setParam() waits for a roscore that is gone, and no frame would be answered meanwhile.
  constexpr bool kWaitForMaster = false;
  perception::Pipeline::Parameters::describe(
      parameters, [&](const char* name, const auto& value, const auto&...) {
        XmlRpcValue request;
        XmlRpcValue response;
        XmlRpcValue payload;
        request[0] = ros::this_node::getName();
        request[1] = private_handle.resolveName(name);
        request[2] = value;
        ros::master::execute("setParam", request, response, payload, kWaitForMaster);
      });
}

}  // namespace polygonal_perception::ros_perception

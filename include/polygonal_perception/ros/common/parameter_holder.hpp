#pragma once

#include <ros/console.h>
#include <ros/node_handle.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>

#include "polygonal_perception/parameters/parameter_check.hpp"
#include "polygonal_perception/ros/common/parameter_list.hpp"
#include "polygonal_perception/ros/common/parameter_reader.hpp"
#include "polygonal_perception/ros/common/reconfigure_messages.hpp"
#include "polygonal_perception/ros/common/reconfigure_server.hpp"

namespace polygonal_perception::ros_common {

/// The names that a struct lists in retired(), if it does.
template <class Parameters>
auto retiredNames(int /*has_some*/) -> decltype(Parameters::retired())
{
  return Parameters::retired();
}
template <class Parameters>
std::vector<parameters::RetiredName> retiredNames(...)
{
  return {};
}

/// Lets a struct that has a complete() fill in those of its values that depend on others and that nobody has set.
template <class Parameters>
auto complete(Parameters& values, const ros::NodeHandle& handle, int /*has_it*/)
    -> decltype(values.complete(std::function<bool(const char*)>()))
{
  values.complete([&handle](const char* name) { return handle.hasParam(name); });
}
template <class Parameters>
void complete(Parameters& /*values*/, const ros::NodeHandle& /*handle*/, ...)
{
}

/// Reads a node's parameters, and gives those back their defaults that contradict one another.
template <class Parameters>
Parameters readParameters(const ros::NodeHandle& private_handle, ParameterReport& report)
{
  Parameters values;
  Parameters defaults;
  ParameterList list = listParameters(values);
  const ParameterList default_list = listParameters(defaults);
  report = readParameters(private_handle, list, retiredNames<Parameters>(0));
  complete(values, private_handle, 0);
  // Each is within its range now; some may still contradict one another.
  while (const auto fault = parameters::findFault(values)) {
    report.errors.push_back("parameters in " + private_handle.getNamespace() + ": " + fault->reason +
                            "; their defaults stay");
    for (std::size_t k = 0; k < list.size(); ++k) {
      if (std::count(fault->names.begin(), fault->names.end(), list[k].name) > 0)
        list[k].copyFrom(default_list[k]);
    }
  }
  return values;
}

/// The one holder of a node's parameters in force: reads them when the node starts, says in the log what is
/// wrong with them, and lets dynamic_reconfigure change the numbers. A bad value never gets in; the last good
/// one stays.
///
/// @tparam Parameters  with describe() (parameters/parameter_table.hpp) and conflict(), which says which
///                     values contradict one another though each is within its range
template <class Parameters>
class ParameterHolder
{
public:
  explicit ParameterHolder(const ros::NodeHandle& private_handle) : handle_(private_handle)
  {
    ParameterReport report;
    values_ = readParameters<Parameters>(private_handle, report);
    for (const std::string& error : report.errors) ROS_ERROR_STREAM(error);
    for (const std::string& warning : report.warnings) ROS_WARN_STREAM(warning);
  }

  ParameterHolder(const ParameterHolder&) = delete;
  ParameterHolder& operator=(const ParameterHolder&) = delete;

  const Parameters& operator*() const { return values_; }
  const Parameters* operator->() const { return &values_; }

  /// Begins to take sets from clients.
  /// @param gate     values change inside it
  /// @param changed  called there with each new set that is good as a whole, before it is
  ///                 in force
  void serve(std::shared_ptr<CallbackGate> gate, std::function<void(const Parameters&)> changed)
  {
    Parameters defaults;
    server_ =
        std::make_unique<ReconfigureServer>(handle_, listParameters(defaults), listParameters(values_),
                                            [this, gate = std::move(gate), changed = std::move(changed)](
                                                const dynamic_reconfigure::Config& config) {
                                              const auto inside = gate->enter();
                                              if (!inside.owns_lock()) return std::string("the node ends");
                                              Parameters wanted = values_;
                                              std::string error = mergeConfig(config, listParameters(wanted));
                                              if (!error.empty()) return error;
                                              if (const auto fault = parameters::findFault(wanted))
                                                return fault->reason;
                                              changed(wanted);
                                              values_ = wanted;
                                              return error;
                                            });
  }

  /// Ends the service; waits for a call under way, and no other comes through.
  void shutdown()
  {
    if (server_) server_->shutdown();
  }

private:
  ros::NodeHandle handle_;
  Parameters values_;
  std::unique_ptr<ReconfigureServer> server_;
};

}  // namespace polygonal_perception::ros_common

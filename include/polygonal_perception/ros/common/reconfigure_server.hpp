#pragma once

#include <dynamic_reconfigure/Reconfigure.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/service_server.h>

#include <functional>
#include <memory>
#include <string>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/ros/common/callback_gate.hpp"
#include "polygonal_perception/ros/common/parameter_list.hpp"

namespace polygonal_perception::ros_common {

/// Lets clients of dynamic_reconfigure change the numbers among a node's parameters.
///
/// It speaks the protocol itself, straight from describe(), where ranges, units and help text stand already:
/// a generated .cfg would repeat them all, dynamic_reconfigure::Server clamps a bad value in silence instead
/// of refusing the set, and its mutex may be gone before its service is when a nodelet is unloaded.
class POLYGONAL_PERCEPTION_EXPORT ReconfigureServer
{
public:
  /// Takes a client's set over, or leaves everything as it is and says why.
  using Change = std::function<std::string(const dynamic_reconfigure::Config& wanted)>;

  /// @param private_handle  where set_parameters, parameter_descriptions and parameter_updates are
  /// @param defaults        for the descriptions
  /// @param in_force        the values as they are at any time; what it points to must outlive the server
  /// @param change          called from the handle's queue
  ReconfigureServer(const ros::NodeHandle& private_handle, const ParameterList& defaults,
                    ParameterList in_force, Change change);
  ~ReconfigureServer();

  /// Ends the service; waits for a call under way, and no other comes through.
  void shutdown();

private:
  void onSet(const dynamic_reconfigure::Config& request, dynamic_reconfigure::Config& response);

  std::shared_ptr<CallbackGate> gate_ = std::make_shared<CallbackGate>();
  ros::NodeHandle handle_;
  ParameterList in_force_;
  Change change_;
  ros::Publisher descriptions_;
  ros::Publisher updates_;
  ros::ServiceServer service_;
};

}  // namespace polygonal_perception::ros_common

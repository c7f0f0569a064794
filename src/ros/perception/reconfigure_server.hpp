#pragma once

#include <dynamic_reconfigure/Reconfigure.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/service_server.h>

#include <functional>
#include <memory>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/perception/pipeline.hpp"
#include "polygonal_perception/ros/common/callback_gate.hpp"

namespace polygonal_perception::ros_perception {

/// Lets clients of dynamic_reconfigure change the pipeline's parameters.
///
/// It speaks the protocol itself, straight from the stages' describe(), where ranges, units and help text
/// stand already: a generated .cfg would repeat them all, dynamic_reconfigure::Server clamps a bad value in
/// silence instead of refusing the set, and its mutex may be gone before its service is when a nodelet is
/// unloaded.
class POLYGONAL_PERCEPTION_EXPORT ReconfigureServer
{
public:
  using Apply = std::function<void(const perception::Pipeline::Parameters&)>;

  /// @param private_handle  where set_parameters, parameter_descriptions and parameter_updates are
  /// @param initial         in force now
  /// @param apply           called from the handle's queue with each new set that is good as a whole
  ReconfigureServer(const ros::NodeHandle& private_handle, const perception::Pipeline::Parameters& initial,
                    Apply apply);
  ~ReconfigureServer();

  /// Ends the service; waits for a call under way, and no other comes through.
  void shutdown();

private:
  void onSet(const dynamic_reconfigure::Config& request, dynamic_reconfigure::Config& response);

  std::shared_ptr<ros_common::CallbackGate> gate_ = std::make_shared<ros_common::CallbackGate>();
  ros::NodeHandle handle_;
  perception::Pipeline::Parameters current_;
  Apply apply_;
  ros::Publisher descriptions_;
  ros::Publisher updates_;
  ros::ServiceServer service_;
};

}  // namespace polygonal_perception::ros_perception

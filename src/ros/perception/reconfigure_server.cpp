#include "ros/perception/reconfigure_server.hpp"

#include <ros/console.h>

#include "polygonal_perception/perception/parameter_check.hpp"
#include "ros/common/reconfigure_messages.hpp"
#include "ros/perception/node_parameters.hpp"

namespace polygonal_perception::ros_perception {

ReconfigureServer::ReconfigureServer(const ros::NodeHandle& private_handle,
                                     const perception::Pipeline::Parameters& initial, Apply apply)
    : handle_(private_handle), current_(initial), apply_(std::move(apply))
{
  constexpr bool kLatch = true;
  writePipelineParameters(handle_, current_);
  descriptions_ =
      handle_.advertise<dynamic_reconfigure::ConfigDescription>("parameter_descriptions", 1, kLatch);
  updates_ = handle_.advertise<dynamic_reconfigure::Config>("parameter_updates", 1, kLatch);
  descriptions_.publish(ros_common::describeConfig());
  updates_.publish(ros_common::toConfig(current_));
  using dynamic_reconfigure::Reconfigure;
  const boost::function<bool(Reconfigure::Request&, Reconfigure::Response&)> set =
      [this, gate = gate_](Reconfigure::Request& request, Reconfigure::Response& response) {
        const auto inside = gate->enter();
        if (inside.owns_lock()) onSet(request.config, response.config);
        return inside.owns_lock();
      };
  service_ = handle_.advertiseService("set_parameters", set);
}

ReconfigureServer::~ReconfigureServer()
{
  shutdown();
}

void ReconfigureServer::shutdown()
{
  gate_->close();
  service_.shutdown();
  descriptions_.shutdown();
  updates_.shutdown();
}

void ReconfigureServer::onSet(const dynamic_reconfigure::Config& request,
                              dynamic_reconfigure::Config& response)
{
  perception::Pipeline::Parameters wanted = current_;
  std::string error = ros_common::mergeConfig(request, wanted);
  if (error.empty()) {
    if (const auto fault = perception::findFault(wanted)) error = fault->reason;
  }
  if (error.empty()) {
    apply_(wanted);
    current_ = wanted;
    writePipelineParameters(handle_, current_);
  } else {
    ROS_ERROR_STREAM("[" << handle_.getNamespace() << "] set of parameters refused: " << error
                         << "; the old set stays");
  }
  // Also after a refusal, so that the client shows what is in force.
  response = ros_common::toConfig(current_);
  updates_.publish(response);
}

}  // namespace polygonal_perception::ros_perception

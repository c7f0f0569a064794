#include "polygonal_perception/ros/common/reconfigure_server.hpp"

#include <ros/console.h>

#include <utility>

#include "polygonal_perception/ros/common/parameter_reader.hpp"
#include "polygonal_perception/ros/common/reconfigure_messages.hpp"

namespace polygonal_perception::ros_common {

ReconfigureServer::ReconfigureServer(const ros::NodeHandle& private_handle, const ParameterList& defaults,
                                     ParameterList in_force, Change change)
    : handle_(private_handle), in_force_(std::move(in_force)), change_(std::move(change))
{
  constexpr bool kLatch = true;
  writeParameters(handle_, in_force_);
  descriptions_ =
      handle_.advertise<dynamic_reconfigure::ConfigDescription>("parameter_descriptions", 1, kLatch);
  updates_ = handle_.advertise<dynamic_reconfigure::Config>("parameter_updates", 1, kLatch);
  descriptions_.publish(describeConfig(defaults));
  updates_.publish(toConfig(in_force_));
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
  const std::string error = change_(request);
  if (error.empty()) {
    writeParameters(handle_, in_force_);
  } else {
    ROS_ERROR_STREAM("[" << handle_.getNamespace() << "] set of parameters refused: " << error
                         << "; the old set stays");
  }
  // Also after a refusal, so that the client shows what is in force.
  response = toConfig(in_force_);
  updates_.publish(response);
}

}  // namespace polygonal_perception::ros_common

#include <nodelet/nodelet.h>

#include <memory>
#include <pluginlib/class_list_macros.hpp>

#include "cameras/simulation_ros/simulated_camera_ros.hpp"

namespace polygonal_perception::simulation_ros {

/// The simulated camera in a nodelet manager, so that its frames reach the pipeline without a copy.
class SimulatedCameraNodelet : public nodelet::Nodelet
{
private:
  void onInit() override
  {
    // An exception that left onInit would take the whole manager down.
    try {
      camera_ = std::make_unique<SimulatedCameraRos>(getNodeHandle(), getPrivateNodeHandle());
    } catch (const std::exception& e) {
      NODELET_FATAL("The simulated camera cannot start: %s", e.what());
    }
  }

  std::unique_ptr<SimulatedCameraRos> camera_;
};

}  // namespace polygonal_perception::simulation_ros

PLUGINLIB_EXPORT_CLASS(polygonal_perception::simulation_ros::SimulatedCameraNodelet, nodelet::Nodelet)

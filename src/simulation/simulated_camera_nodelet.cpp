#include <nodelet/nodelet.h>

#include <memory>
#include <pluginlib/class_list_macros.hpp>

#include "simulated_camera_ros.hpp"

namespace polygonal_perception {

/// The simulated camera in a nodelet manager, so that its frames reach the pipeline without a copy.
class SimulatedCameraNodelet : public nodelet::Nodelet
{
private:
  void onInit() override
  {
    // An exception that left onInit would take the whole manager down.
    try {
      camera_ = std::make_unique<simulation::SimulatedCameraRos>(getNodeHandle(), getPrivateNodeHandle());
    } catch (const std::exception& e) {
      NODELET_FATAL("The simulated camera cannot start: %s", e.what());
    }
  }

  std::unique_ptr<simulation::SimulatedCameraRos> camera_;
};

}  // namespace polygonal_perception

PLUGINLIB_EXPORT_CLASS(polygonal_perception::SimulatedCameraNodelet, nodelet::Nodelet)

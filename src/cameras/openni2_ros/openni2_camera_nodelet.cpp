#include <nodelet/nodelet.h>

#include <memory>
#include <pluginlib/class_list_macros.hpp>

#include "cameras/openni2_ros/openni2_camera_ros.hpp"

namespace polygonal_perception::openni2_ros {

/// The OpenNI2 camera in a nodelet manager, so that its frames reach the pipeline without a copy.
class OpenNI2Camera : public nodelet::Nodelet
{
private:
  void onInit() override
  {
    // An exception that left onInit would take the whole manager down.
    try {
      camera_ = std::make_unique<OpenNI2CameraRos>(getNodeHandle(), getPrivateNodeHandle());
    } catch (const std::exception& e) {
      NODELET_FATAL("The OpenNI2 camera cannot start: %s", e.what());
    }
  }

  std::unique_ptr<OpenNI2CameraRos> camera_;
};

}  // namespace polygonal_perception::openni2_ros

PLUGINLIB_EXPORT_CLASS(polygonal_perception::openni2_ros::OpenNI2Camera, nodelet::Nodelet)

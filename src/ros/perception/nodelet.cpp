#include <nodelet/nodelet.h>

#include <exception>
#include <memory>
#include <pluginlib/class_list_macros.hpp>

#include "ros/perception/polygonal_perception_ros.hpp"

namespace polygonal_perception::ros_perception {

/// PolygonalPerceptionRos in a nodelet manager, best the camera driver's: its clouds are then read where they
/// lie.
class PolygonalPerception : public nodelet::Nodelet
{
private:
  void onInit() override
  {
    // An exception from here would take the manager down, and with it the camera's driver.
    try {
      perception_ = std::make_unique<PolygonalPerceptionRos>(getNodeHandle(), getPrivateNodeHandle());
    } catch (const std::exception& error) {
      NODELET_ERROR("could not start: %s", error.what());
    } catch (...) {
      NODELET_ERROR("could not start, for an unknown reason");
    }
  }

  std::unique_ptr<PolygonalPerceptionRos> perception_;
};

}  // namespace polygonal_perception::ros_perception

PLUGINLIB_EXPORT_CLASS(polygonal_perception::ros_perception::PolygonalPerception, nodelet::Nodelet)

#pragma once

#include <image_transport/image_transport.h>
#include <ros/publisher.h>

#include <cstdint>
#include <memory>

#include "cameras/simulation_ros/simulated_camera_parameters.hpp"
#include "polygonal_perception/cameras/simulation/simulated_camera.hpp"

namespace polygonal_perception::simulation_ros {

/// One camera of the robot, and what it publishes. It renders only what somebody reads.
class CameraTopics
{
public:
  /// @param number  which of the robot's cameras
  /// @param robot   that carries it, or null: it moves as the parameters say
  CameraTopics(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
               const SimulatedCameraParameters& parameters, std::uint32_t number,
               const std::shared_ptr<const simulation::Trajectory>& robot);

  const simulation::SimulatedCamera& camera() const { return camera_; }
  const SimulatedCameraParameters::CameraNames& names() const { return names_; }

  void publish(std::uint32_t index, const ros::Time& stamp);

private:
  SimulatedCameraParameters::CameraNames names_;
  simulation::SimulatedCamera camera_;
  simulation::SimulatedFrame frame_;
  std::uint32_t sequence_ = 0;  // of the last frame: roscpp numbers messages for other processes only

  image_transport::CameraPublisher raw_;
  image_transport::Publisher rectified_;
  ros::Publisher points_;
  ros::Publisher true_floor_;
};

}  // namespace polygonal_perception::simulation_ros

#pragma once

#include <image_transport/image_transport.h>
#include <ros/ros.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

#include <cstdint>
#include <memory>
#include <string>

#include "polygonal_perception/cameras/simulation/simulated_camera.hpp"
#include "polygonal_perception/export.hpp"

namespace polygonal_perception::simulation_ros {

/// Publishes a simulated camera's frames as openni2_camera does, the transforms of the robot that carries it,
/// and the truth. It renders only what somebody reads, and leaves frames out when it is too slow.
///
/// Topics below the namespace `~camera` (default "camera"): depth/image_raw and depth/image_rect (16UC1, mm),
/// depth/camera_info, depth/points. Private: ground_truth/floor (FloorPlane, optical frame),
/// ground_truth/obstacles (PolygonArray, world frame, not inflated).
///
/// Private parameters: camera; scene (one of sceneNames()), trajectory (one of trajectoryNames()), seed; rate
/// [Hz]; width, height [px]; noise (false: ideal depth) and noise_<name> for each of DepthNoise::Parameters;
/// min_height, max_height [m] of the true obstacles; publish_tf, world_frame (odom), base_frame (base_link),
/// camera_frame (camera_link), optical_frame (camera_depth_optical_frame).
class POLYGONAL_PERCEPTION_EXPORT SimulatedCameraRos
{
public:
  /// Reads the parameters and starts.
  /// @throws std::exception, with a message that names the parameter, when one is not acceptable
  SimulatedCameraRos(const ros::NodeHandle& node, const ros::NodeHandle& private_node);
  ~SimulatedCameraRos();
  SimulatedCameraRos(const SimulatedCameraRos&) = delete;
  SimulatedCameraRos& operator=(const SimulatedCameraRos&) = delete;

private:
  void tick();
  bool frameIsRead() const;
  void publishFrame(const ros::Time& stamp);

  std::unique_ptr<simulation::SimulatedCamera> camera_;
  simulation::SimulatedFrame frame_;
  std::uint32_t sequence_ = 0;  // of the last frame: roscpp numbers messages for other processes only
  double min_height_ = 0.03;    // [m] of the obstacles in the truth
  double max_height_ = 0.60;    // [m]
  bool publish_tf_ = true;
  std::string world_frame_;
  std::string base_frame_;
  std::string body_frame_;
  std::string optical_frame_;

  image_transport::CameraPublisher raw_;
  image_transport::Publisher rectified_;
  ros::Publisher points_;
  ros::Publisher true_floor_;
  ros::Publisher true_obstacles_;
  tf2_ros::TransformBroadcaster tf_;
  tf2_ros::StaticTransformBroadcaster static_tf_;
  ros::Time start_;
  ros::Timer timer_;
};

}  // namespace polygonal_perception::simulation_ros

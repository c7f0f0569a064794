#pragma once

#include <ros/node_handle.h>

#include <memory>

#include "polygonal_perception/export.hpp"

namespace polygonal_perception::simulation_ros {

/// Publishes the frames of a robot's simulated camera, or of several, as openni2_camera does, the transforms of the
/// robot that carries them, and the truth. It renders only what somebody reads, and leaves frames out when it is too
/// slow.
///
/// Topics below the namespace `~camera` (default "camera"): depth/image_raw and depth/image_rect (16UC1, mm),
/// depth/camera_info, depth/points. Private: ground_truth/floor (FloorPlane, optical frame),
/// ground_truth/obstacles (PolygonArray, world frame, not inflated).
///
/// With the trajectory cmd_vel the robot obeys `cmd_vel` (geometry_msgs/Twist) within the limits max_vel_x, ... (those of
/// planning::RobotModel), after latency, as long as command_timeout; it publishes `odom` (nav_msgs/Odometry), and says in the
/// log when it bumps into something, which it does with its radius.
///
/// With several cameras each has its topics below its name, frames NAME_link and NAME_depth_optical_frame, and
/// ground_truth/NAME/floor.
///
/// Private parameters: camera, or cameras (a list of names, spread evenly around the robot); scene (one of simulation::sceneNames()), trajectory (one of
/// trajectoryNames()), seed; rate [Hz]; width, height [px]; noise (false: ideal depth, whatever follows) and
/// noise_<name> for each of DepthNoise::Parameters; min_height, max_height [m] of the true obstacles;
/// publish_tf, world_frame (odom), base_frame (base_link), camera_frame (camera_link), optical_frame
/// (camera_depth_optical_frame). One that is not acceptable is refused with a message in the log, and its
/// default stays.
class POLYGONAL_PERCEPTION_EXPORT SimulatedCameraNode
{
public:
  /// Reads the parameters and starts.
  SimulatedCameraNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle);
  ~SimulatedCameraNode();
  SimulatedCameraNode(const SimulatedCameraNode&) = delete;
  SimulatedCameraNode& operator=(const SimulatedCameraNode&) = delete;

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace polygonal_perception::simulation_ros

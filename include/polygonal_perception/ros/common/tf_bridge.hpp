#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/node_handle.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_broadcaster.h>
#include <tf2_ros/transform_listener.h>

#include <Eigen/Geometry>
#include <string>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/ros/common/expected.hpp"

namespace polygonal_perception::ros_common {

/// Listens to tf in a thread of its own and answers at once: a transform or the reason why there is none,
/// never the identity in its place.
class POLYGONAL_PERCEPTION_EXPORT TfBridge
{
public:
  TfBridge() : listener_(buffer_) {}

  /// @return the transform that takes points from `source` into `target` at that time, or the reason why not,
  /// which names
  ///         both frames and the stamp
  Expected<Eigen::Isometry3d> lookup(const std::string& target, const std::string& source,
                                     const ros::Time& stamp) const;

  /// Forgets all moving transforms: time has jumped.
  void clear() { buffer_.clear(); }

private:
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
};

/// The pose of the floor frame in the output frame: x, y and yaw from localisation; roll, pitch and height
/// are the floor's (section IV).
///
/// The floor frame lies straight under the input frame, and its yaw is the one that brings what the floor and
/// what tf say of the camera's attitude together best.
///
/// @param input_to_output  from tf
/// @param input_to_floor   Pipeline::Result::to_floor_frame
POLYGONAL_PERCEPTION_EXPORT Eigen::Isometry2d outputPose(const Eigen::Isometry3d& input_to_output,
                                                         const Eigen::Isometry3d& input_to_floor);

/// The floor frame as a child of the input's frame.
POLYGONAL_PERCEPTION_EXPORT geometry_msgs::TransformStamped toTransform(
    const std_msgs::Header& input, const std::string& floor_frame, const Eigen::Isometry3d& input_to_floor);

}  // namespace polygonal_perception::ros_common

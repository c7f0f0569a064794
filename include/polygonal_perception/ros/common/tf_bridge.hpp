#pragma once

#include <ros/node_handle.h>
#include <tf2_ros/buffer.h>
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
  ///         which names both frames and the stamp
  Expected<Eigen::Isometry3d> lookup(const std::string& target, const std::string& source,
                                     const ros::Time& stamp) const;

  /// Forgets all moving transforms: time has jumped.
  void clear() { buffer_.clear(); }

private:
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
};

}  // namespace polygonal_perception::ros_common

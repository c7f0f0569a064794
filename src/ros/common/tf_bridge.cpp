#include "polygonal_perception/ros/common/tf_bridge.hpp"

#include <exception>
#include <sstream>

namespace polygonal_perception::ros_common {

Expected<Eigen::Isometry3d> TfBridge::lookup(const std::string& target, const std::string& source,
                                             const ros::Time& stamp) const
{
  // tf takes it for "the latest", which may be of any age.
  if (stamp.isZero()) {
    return Expected<Eigen::Isometry3d>::failure("no transform from '" + source + "' to '" + target +
                                                "': header.stamp is 0, accepted is the frame's time");
  }
  try {
    const geometry_msgs::Transform transform = buffer_.lookupTransform(target, source, stamp).transform;
    const auto& q = transform.rotation;
    Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
    result.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
    result.translation() << transform.translation.x, transform.translation.y, transform.translation.z;
    if (result.matrix().allFinite()) return result;
    return Expected<Eigen::Isometry3d>::failure("the transform from '" + source + "' to '" + target +
                                                "' is not finite");
  } catch (const std::exception& reason) {
    // tf2's own, and what ros::Duration throws in tf2 where a stamp is farther away than 68 years.
    std::ostringstream text;
    text << "no transform from '" << source << "' to '" << target << "' at " << stamp << ": "
         << reason.what();
    return Expected<Eigen::Isometry3d>::failure(text.str());
  }
}

}  // namespace polygonal_perception::ros_common

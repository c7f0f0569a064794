#include "ros/perception/floor_transforms.hpp"

#include <cmath>

namespace polygonal_perception::ros_perception {

Eigen::Isometry2d poseInOutputFrame(const Eigen::Isometry3d& input_to_output,
                                    const Eigen::Isometry3d& input_to_floor)
{
  // The rotation about z that is nearest to R in the least-squares sense; where the two agree R is one.
  const Eigen::Matrix3d r = input_to_output.linear() * input_to_floor.linear().transpose();
  const double yaw = std::atan2(r(1, 0) - r(0, 1), r(0, 0) + r(1, 1));
  Eigen::Isometry2d pose = Eigen::Isometry2d::Identity();
  pose.linear() = Eigen::Rotation2Dd(yaw).toRotationMatrix();
  pose.translation() = input_to_output.translation().head<2>();
  return pose;
}

geometry_msgs::TransformStamped toTransform(const std_msgs::Header& input, const std::string& floor_frame,
                                            const Eigen::Isometry3d& input_to_floor)
{
  geometry_msgs::TransformStamped message;
  message.header = input;
  message.child_frame_id = floor_frame;
  const Eigen::Isometry3d floor_to_input = input_to_floor.inverse(Eigen::Isometry);
  const Eigen::Quaterniond q(floor_to_input.linear());
  message.transform.translation.x = floor_to_input.translation().x();
  message.transform.translation.y = floor_to_input.translation().y();
  message.transform.translation.z = floor_to_input.translation().z();
  message.transform.rotation.x = q.x();
  message.transform.rotation.y = q.y();
  message.transform.rotation.z = q.z();
  message.transform.rotation.w = q.w();
  return message;
}

}  // namespace polygonal_perception::ros_perception

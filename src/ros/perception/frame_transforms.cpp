#include "ros/perception/frame_transforms.hpp"

#include "ros/perception/printed.hpp"

namespace polygonal_perception::ros_perception {

namespace {

using Transform = ros_common::Expected<Eigen::Isometry3d>;

/// Where the floor is in the input's frame: z = 0 of the mount's.
ros_common::Expected<geometry::Plane> floorOfMount(const Transform& input_to_mount,
                                                   const std::string& mount_frame)
{
  using Result = ros_common::Expected<geometry::Plane>;
  if (!input_to_mount) return Result::failure(input_to_mount.error());
  const double height = input_to_mount->translation().z();
  if (height > 0.0) return geometry::Plane{input_to_mount->linear().row(2).transpose(), height};
  return Result::failure(printed("the input's frame is %.3f m above mount_frame '", height) + mount_frame +
                         "', accepted is any height above 0");
}

}  // namespace

FrameTransforms lookUpTransforms(const PerceptionParameters& parameters, const ros_common::TfBridge* tf,
                                 const std_msgs::Header& header, bool needs_seed)
{
  const auto lookUp = [&](const std::string& target) {
    return tf->lookup(target, header.frame_id, header.stamp);
  };
  FrameTransforms transforms;
  if (!parameters.mount_frame.empty()) {
    const auto floor = floorOfMount(lookUp(parameters.mount_frame), parameters.mount_frame);
    if (floor) transforms.hints.mount = *floor;
    transforms.missing_input = floor.error();
  } else if (!parameters.up_frame.empty() && needs_seed) {
    const Transform input_to_up = lookUp(parameters.up_frame);
    if (input_to_up) transforms.hints.up = input_to_up->linear().row(2).transpose();
    transforms.missing_input = input_to_up.error();
  }
  for (const parameters::FrameBox& box : parameters.ignore_boxes) {
    const Transform input_to_box = lookUp(box.frame);
    const Eigen::AlignedBox3d extent(Eigen::Vector3d(box.from.data()), Eigen::Vector3d(box.to.data()));
    if (input_to_box) transforms.ignored.add(*input_to_box, extent);
    if (!input_to_box) transforms.missing_input = input_to_box.error();
  }
  if (parameters.hasOutputFrame()) {
    const Transform input_to_output = lookUp(parameters.output_frame);
    if (input_to_output) {
      transforms.input_to_output = *input_to_output;
      transforms.hints.level = input_to_output->linear().row(2).transpose();
    }
    transforms.missing_output = input_to_output.error();
  }
  return transforms;
}

}  // namespace polygonal_perception::ros_perception

#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

namespace polygonal_perception::perception {

/// Boxes that hold the robot's own parts (a bumper, a gripper): what is seen in them is no point.
class IgnoredBoxes
{
public:
  /// @param input_to_box  from the input's frame into that of the box
  /// @param box           [m] its borders are inside
  void add(const Eigen::Isometry3d& input_to_box, const Eigen::AlignedBox3d& box)
  {
    boxes_.push_back({input_to_box.cast<float>(), box.cast<float>()});
  }

  bool empty() const { return boxes_.empty(); }

  /// @param point  in the input's frame [m]; NaN is in none
  bool contain(const Eigen::Vector3f& point) const
  {
    return std::any_of(boxes_.begin(), boxes_.end(),
                       [&](const Box& box) { return box.extent.contains(box.from_input * point); });
  }

private:
  struct Box
  {
    Eigen::Isometry3f from_input;
    Eigen::AlignedBox3f extent;
  };

  std::vector<Box> boxes_;
};

}  // namespace polygonal_perception::perception

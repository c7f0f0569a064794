#include "polygonal_perception/planning/arc.hpp"

namespace polygonal_perception::planning {

Arc::Arc(const Pose& start, const Twist& twist, double begin)
    : start_(start), speed_(twist.speed()), turn_rate_(twist.theta), begin_(begin)
{
  const double yaw = start.yaw + (speed_ > 0.0 ? std::atan2(twist.y, twist.x) : 0.0);
  direction_ = {std::cos(yaw), std::sin(yaw)};
}

Eigen::Vector2d Arc::position(double time) const
{
  // The chord: its direction is the mean of those at its ends.
  const double passed = time - begin_;
  const double half = 0.5 * turn_rate_ * passed;
  const double c = std::cos(half);
  const double s = std::sin(half);
  const Eigen::Vector2d along(c * direction_.x() - s * direction_.y(),
                              s * direction_.x() + c * direction_.y());
  return start_.position + speed_ * passed * sinc(half, s) * along;
}

}  // namespace polygonal_perception::planning

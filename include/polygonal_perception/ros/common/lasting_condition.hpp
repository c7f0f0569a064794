#pragma once

#include <ros/time.h>

#include <optional>

namespace polygonal_perception::ros_common {

/// What is worth a word only when it has lasted for a while, and then once: until it has ended and come back.
class LastingCondition
{
public:
  explicit LastingCondition(ros::Duration while_) : while_(while_) {}

  /// @return whether it is to be said now
  bool update(bool holds, const ros::Time& stamp)
  {
    if (!holds) {
      reset();
      return false;
    }
    if (!since_) since_ = stamp;
    // As numbers: a difference of stamps throws where it is more than 68 years.
    if (is_said_ || stamp.toSec() - since_->toSec() < while_.toSec()) return false;
    is_said_ = true;
    return true;
  }

  /// Nobody has looked: as if it had not been there.
  void reset()
  {
    since_.reset();
    is_said_ = false;
  }

private:
  ros::Duration while_;
  std::optional<ros::Time> since_;
  bool is_said_ = false;
};

}  // namespace polygonal_perception::ros_common

#pragma once

#include <ros/time.h>

#include <algorithm>

namespace polygonal_perception::ros_common {

/// Whether a stamp is older than another one by more than some seconds. As numbers: sums and differences of stamps throw at
/// the end of their range.
inline bool isOlder(const ros::Time& stamp, const ros::Time& other, double seconds)
{
  return other.toSec() - stamp.toSec() > seconds;
}

/// Tells messages of one source that come a little out of order from time that has jumped back.
class StampOrder
{
public:
  /// Notes the stamp of a message that has come in; the same one again, of a message that waits, changes nothing.
  /// @return whether time has jumped back. It takes two in a row that are old, for one may have been under way for long.
  bool jumpsBack(const ros::Time& stamp)
  {
    // A driver's stamps may be some frames out of order, but not by so much.
    constexpr double kJump = 1.0;  // [s]
    const bool is_old = isOlder(stamp, newest_, kJump);
    const bool jumps = is_old && !old_.isZero() && stamp > old_;
    old_ = is_old ? stamp : ros::Time();
    return jumps;
  }

  /// A message of that stamp has been taken: what follows is held against it.
  void take(const ros::Time& stamp) { newest_ = std::max(newest_, stamp); }

  /// Of those that were taken; zero before the first.
  const ros::Time& newest() const { return newest_; }

  void reset() { newest_ = old_ = ros::Time(); }

private:
  ros::Time newest_;
  ros::Time old_;  // the last stamp, if it was old
};

}  // namespace polygonal_perception::ros_common

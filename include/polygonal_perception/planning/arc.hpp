#pragma once

#include <Eigen/Core>
#include <cmath>

#include "polygonal_perception/export.hpp"

namespace polygonal_perception::planning {

/// A robot's velocity in its own frame: x ahead, y to the left, counter-clockwise.
struct Twist
{
  double x = 0.0;      ///< [m/s]
  double y = 0.0;      ///< [m/s]
  double theta = 0.0;  ///< [rad/s]

  double speed() const { return std::hypot(x, y); }
};

/// Where a robot is.
struct Pose
{
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< [m]
  double yaw = 0.0;                                    ///< [rad]
};

/// The motion of a robot, or of any point of it, whose twist does not change: a circle's arc, a straight line, a turn on the
/// spot or a stand.
class POLYGONAL_PERCEPTION_EXPORT Arc
{
public:
  /// @param begin  [s] when it is at the start
  Arc(const Pose& start, const Twist& twist, double begin = 0.0);

  /// @param time  [s] on the clock that says when it begins
  Eigen::Vector2d position(double time) const;
  Pose pose(double time) const { return {position(time), start_.yaw + turn_rate_ * (time - begin_)}; }

  const Pose& start() const { return start_; }
  double begin() const { return begin_; }  ///< [s]

  /// In which direction it moves at the start: of length 1, also where it stands.
  const Eigen::Vector2d& direction() const { return direction_; }
  double speed() const { return speed_; }         ///< [m/s] along the arc, never negative
  double turnRate() const { return turn_rate_; }  ///< [rad/s]

private:
  Pose start_;
  Eigen::Vector2d direction_;
  double speed_;
  double turn_rate_;
  double begin_;
};

/// sin(x) / x, also at 0.
/// @param sine  sin(x), which whoever asks has already
inline double sinc(double x, double sine)
{
  constexpr double kSmall = 1e-4;  // the next term of the series is beyond a double's digits
  return std::abs(x) < kSmall ? 1.0 - x * x / 6.0 : sine / x;
}

}  // namespace polygonal_perception::planning

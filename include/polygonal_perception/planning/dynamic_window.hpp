#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/planning/arc.hpp"
#include "polygonal_perception/planning/contact_search.hpp"
#include "polygonal_perception/planning/driving_parameters.hpp"
#include "polygonal_perception/planning/moving_edges.hpp"
#include "polygonal_perception/planning/remaining_path.hpp"
#include "polygonal_perception/planning/robot_model.hpp"

namespace polygonal_perception::planning {

/// What a robot is to do for one period.
struct DriveDecision
{
  enum class Outcome : std::uint8_t
  {
    kDriving,
    kArrived,  ///< within the tolerances of the goal: it stands, or brakes
    kBlocked   ///< no motion is safe, or none gets on: it stands, or brakes
  };
  Outcome outcome = Outcome::kBlocked;
  Twist command;
  double time_to_collision = 0.0;  ///< [s] at the commanded velocity; infinite without one up to sim_time
};

/// The Dynamic Window Approach (D. Fox, W. Burgard and S. Thrun, 1997) among polygons that move (M. Missura and M. Bennewitz,
/// ICRA 2019): of the velocities that a robot can reach, the one that brings it to the end of a path the soonest, and from
/// which it can stop before it touches anything.
///
/// A velocity is admissible if the robot, after it has followed the command for one period, can brake along the arc that it
/// is on then, without entering an obstacle, where this will be by then. Because the next period begins on that arc, the
/// robot can always stop. It is a point: obstacles have grown by its radius.
class POLYGONAL_PERCEPTION_EXPORT DynamicWindow
{
public:
  using Parameters = DrivingParameters;

  /// A velocity that was looked at.
  struct Tried
  {
    Arc arc;
    double duration = 0.0;  ///< [s] as long as the robot may follow it
  };

  explicit DynamicWindow(const Parameters& parameters = {}) : parameters_(parameters) {}
  void configure(const Parameters& parameters) { parameters_ = parameters; }

  /// @param state     of the robot when the command takes effect
  /// @param standing  edges of obstacles
  /// @param moving    of obstacles that move, where they are when the command takes effect
  /// @param path      from about the robot to the goal [m]; at least one point
  /// @param goal_yaw  [rad]
  /// @param period    [s] until the next command takes effect
  DriveDecision decide(const RobotState& state, const std::vector<MovingEdge>& standing,
                       const std::vector<MovingEdge>& moving, const std::vector<Eigen::Vector2d>& path,
                       double goal_yaw, double period);

  /// The command that stops a robot along the arc that it is on.
  Twist brake(const Twist& velocity, double period) const;

  /// Of the last decision: the velocities that are admissible.
  const std::vector<Tried>& tried() const { return tried_; }
  /// Of these the one that was chosen, if any.
  const std::optional<Tried>& chosen() const { return chosen_; }

private:
  /// How a robot goes on after a command.
  struct Followed
  {
    Pose pose;       // after the period
    Twist velocity;  // then
    bool is_safe = false;
  };

  void lookAround(const RobotState& state, const std::vector<MovingEdge>& standing,
                  const std::vector<MovingEdge>& moving, double period);
  void chooseTargets(const Twist& velocity);
  Followed follow(const RobotState& state, const Twist& command, double period) const;
  bool canStop(const Pose& pose, const Twist& velocity, double begin) const;
  bool isFree(const Arc& arc, double until) const;
  /// Whether a motion from inside an obstacle leads out of it at all times.
  bool leadsOut(const Arc& arc, double until) const;
  /// The velocity that a robot has in the mean over some time while it approaches another one.
  Twist mean(const Twist& velocity, const Twist& target, double duration) const;
  double cost(const Arc& arc, double duration) const;
  double changeCost(const Twist& velocity, const Twist& target) const;
  double timeToGo(const Pose& pose) const;
  DriveDecision turnOrStand(const RobotState& state, double goal_yaw, double period);
  double timeToCollision(const Arc& arc) const;

  Parameters parameters_;
  ContactSearch standing_;
  ContactSearch moving_;
  bool is_run_over_ = false;                           // by what moves: it stands until that has passed
  bool is_inside_ = false;                             // what stands
  double depth_ = 0.0;                                 // [m] in it
  Eigen::Vector2d outward_ = Eigen::Vector2d::Zero();  // of the obstacle that contains the robot, of length 1
  RemainingPath path_;
  std::array<std::vector<double>, 3> samples_;  // of x, y and theta
  std::vector<Twist> targets_;
  std::vector<Tried> tried_;
  std::optional<Tried> chosen_;
};

}  // namespace polygonal_perception::planning

#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <deque>
#include <vector>

#include "polygonal_perception/cameras/simulation/scene.hpp"
#include "polygonal_perception/cameras/simulation/trajectory.hpp"
#include "polygonal_perception/export.hpp"
#include "polygonal_perception/planning/robot_model.hpp"

namespace polygonal_perception::simulation {

/// A round robot that obeys velocity commands, within its limits and after its latency, and that bumps into things. It starts
/// where Robotino's trajectory does, with its camera. As a trajectory it knows one time only: where it is now.
class POLYGONAL_PERCEPTION_EXPORT DrivenRobot : public Trajectory
{
public:
  struct Parameters
  {
    planning::RobotModel model;
    double latency = 0.0;  ///< [s] from a command until the base begins to follow it
    double radius = 0.2;   ///< [m]
    /// [s] after which a command holds no longer, as with bases that stop when their computer hangs.
    double command_timeout = 0.5;
  };

  /// @param scene  must outlive the robot
  DrivenRobot(const Scene& scene, std::uint64_t seed, const Parameters& parameters);

  /// A command that is given now.
  void command(const planning::Twist& twist);
  /// Drives on until a time [s]; back to the start, at an earlier one.
  void advanceTo(double time);

  const planning::RobotState& state() const { return state_; }
  /// How often it has driven into something. Who walks into it while it stands bumps himself.
  std::uint32_t bumps() const { return bumps_; }

  Eigen::Isometry3d pose(double time) const override { return base(time) * camera_; }
  Eigen::Isometry3d base(double time) const override;

private:
  struct Given
  {
    double effect = 0.0;  // [s]
    planning::Twist twist;
  };

  void step(double duration);
  /// [m] To the nearest thing, from the robot's border; below 0 where it touches.
  double clearance(const Eigen::Vector2d& position) const;

  const Scene* scene_;
  Parameters parameters_;
  planning::RobotState start_;
  Eigen::Isometry3d camera_;  // in the robot's frame
  std::vector<Outline> standing_;
  planning::RobotState state_;
  double now_ = 0.0;
  std::deque<Given> given_;  // the first of them holds
  bool is_touching_ = false;
  std::uint32_t bumps_ = 0;
};

}  // namespace polygonal_perception::simulation

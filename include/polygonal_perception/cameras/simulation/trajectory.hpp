#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "polygonal_perception/cameras/simulation/scene.hpp"
#include "polygonal_perception/export.hpp"

namespace polygonal_perception::simulation {

/// Where the camera is over time. All poses keep clear of what stands and walks in the scene.
class POLYGONAL_PERCEPTION_EXPORT Trajectory
{
public:
  virtual ~Trajectory() = default;
  /// From the optical frame into the world at a time >= 0 [s].
  virtual Eigen::Isometry3d pose(double time) const = 0;
  /// From the robot's frame (x ahead, z up, its origin under the camera, z = 0 the ground that it stands on) into the
  /// world. Level on the floor unless the trajectory knows better.
  virtual Eigen::Isometry3d base(double time) const;
};

/// The pose of an optical frame (x right, y down, z forward).
/// @param position  [m]
/// @param yaw       [rad] heading, counter-clockwise from x
/// @param pitch     [rad] downwards
/// @param roll      [rad] about the viewing direction, clockwise as the camera sees the world
POLYGONAL_PERCEPTION_EXPORT Eigen::Isometry3d opticalPose(const Eigen::Vector3d& position, double yaw,
                                                          double pitch, double roll);

/// The kinds of trajectories:
/// - robotino: a wheeled robot drives about, camera 0.6..1.0 m up, slight vibration; in a course along its way, as
/// tilted as the ground under its wheels;
/// - nao: a humanoid walks, camera about 0.5 m up, sways, nods and shakes at each heel strike;
/// - smooth_lowest, smooth_low, smooth_high: hand-held, height 0.2..0.5, 0.4..0.7 or 0.7..1.5 m, pitch 0..45
/// deg, roll +-15 deg, all changing smoothly;
/// - independent_lowest, independent_low, independent_high: the same ranges, a pose of its own for each frame at
/// 30 Hz.
POLYGONAL_PERCEPTION_EXPORT const std::vector<std::string>& trajectoryNames();

/// @throws std::invalid_argument when there is no trajectory of that name
/// @throws std::runtime_error when the scene leaves it no room
POLYGONAL_PERCEPTION_EXPORT std::unique_ptr<Trajectory> makeTrajectory(const std::string& name,
                                                                       const Scene& scene,
                                                                       std::uint64_t seed);

}  // namespace polygonal_perception::simulation

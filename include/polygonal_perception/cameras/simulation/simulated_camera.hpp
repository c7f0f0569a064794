#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "polygonal_perception/cameras/simulation/depth_noise.hpp"
#include "polygonal_perception/cameras/simulation/pinhole_camera.hpp"
#include "polygonal_perception/cameras/simulation/ray_caster.hpp"
#include "polygonal_perception/cameras/simulation/scene.hpp"
#include "polygonal_perception/cameras/simulation/trajectory.hpp"
#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/plane.hpp"

namespace polygonal_perception::simulation {

/// A rendered frame and the truth about it.
struct SimulatedFrame
{
  std::uint32_t index = 0;
  double time = 0.0;                                                  ///< [s] since the start
  Eigen::Isometry3d camera_to_world = Eigen::Isometry3d::Identity();  ///< from the optical frame
  Eigen::Isometry3d base_to_world = Eigen::Isometry3d::Identity();    ///< see Trajectory::base
  geometry::Plane floor;  ///< that the robot stands on, in the optical frame
  /// Of all pixels: floor with a return; while the robot is not on the floor, the other ground of the course.
  double floor_fraction = 0.0;
  std::vector<float> depth;  ///< [m] with noise; NaN = no return
  RayImage truth;            ///< the same without noise
};

/// A depth camera that moves through a scene: everything that is rendered in this package comes from here.
class POLYGONAL_PERCEPTION_EXPORT SimulatedCamera
{
public:
  struct Options
  {
    std::string scene = "office";         ///< one of sceneNames()
    std::string trajectory = "robotino";  ///< one of trajectoryNames()
    std::uint64_t seed = 1;               ///< of the layout, the trajectory and the noise
    double rate = 30.0;                   ///< [Hz]
    /// Which of the robot's cameras, which are spread evenly around it: the first looks as the trajectory says, the
    /// others are turned about the robot's upright axis, counter-clockwise.
    std::uint32_t number = 0;
    std::uint32_t count = 1;
    PinholeCamera camera;
    DepthNoise::Parameters noise;
  };

  /// @throws std::invalid_argument for an unknown name, an empty image, a camera that the robot does not have, or
  ///         a rate or a parameter out of its range
  /// @param trajectory  in the place of the one that the options name
  explicit SimulatedCamera(const Options& options, std::shared_ptr<const Trajectory> trajectory = nullptr);

  const Options& options() const { return options_; }
  const Scene& scene() const { return *scene_; }
  /// The planes whose numbers are in SimulatedFrame::truth, in the world frame.
  const ScenePlanes& planes() const { return caster_.planes(); }

  /// Where the camera is at time index / rate, from its optical frame into the world.
  Eigen::Isometry3d pose(std::uint32_t index) const;
  /// Where the robot is then; see Trajectory::base.
  Eigen::Isometry3d base(std::uint32_t index) const { return trajectory_->base(index / options_.rate); }

  /// Renders the frame at time index / rate, the same whenever and in whichever order it is asked for.
  /// @param frame  its memory is used again
  void render(std::uint32_t index, SimulatedFrame& frame);

private:
  Options options_;
  std::unique_ptr<const Scene> scene_;
  std::shared_ptr<const Trajectory> trajectory_;
  RayCaster caster_;
  DepthNoise noise_;
};

/// As OpenNI gives it: millimetres, rounded; 0 where there is no return or it is beyond 65535 mm.
POLYGONAL_PERCEPTION_EXPORT void toMillimetres(const std::vector<float>& depth, std::uint16_t* millimetres);

}  // namespace polygonal_perception::simulation

#include "polygonal_perception/cameras/simulation/simulated_camera.hpp"

#include <stdexcept>
#include <utility>

#include "polygonal_perception/cameras/simulation/random.hpp"

namespace polygonal_perception::simulation {

namespace {

/// Scenes and trajectories of the same seed have nothing else in common.
std::uint64_t mixName(std::uint64_t seed, const std::string& name)
{
  for (const char letter : name) seed = mixBits(seed ^ static_cast<unsigned char>(letter));
  return seed;
}

const SimulatedCamera::Options& checked(const SimulatedCamera::Options& options)
{
  // Written so that NaN fails.
  if (!(options.rate > 0.0 && options.rate <= 1000.0))
    throw std::invalid_argument("rate must be within 0..1000 Hz");
  if (options.camera.size() == 0) throw std::invalid_argument("width and height must be positive");
  if (options.number >= options.count) throw std::invalid_argument("number must be less than count");
  return options;
}

}  // namespace

SimulatedCamera::SimulatedCamera(const Options& options, std::shared_ptr<const Trajectory> trajectory)
    : options_(checked(options)),
      scene_(std::make_unique<Scene>(makeScene(options.scene, options.seed))),
      trajectory_(trajectory
                      ? std::move(trajectory)
                      : makeTrajectory(options.trajectory, *scene_, mixName(options.seed, options.scene))),
      caster_(*scene_),
      noise_(options.noise, mixName(options.seed, options.scene + options.trajectory) + options.number)
{
}

Eigen::Isometry3d SimulatedCamera::pose(std::uint32_t index) const
{
  const Eigen::Isometry3d first = trajectory_->pose(index / options_.rate);
  if (options_.number == 0) return first;
  const Eigen::Isometry3d robot = base(index);
  const Eigen::AngleAxisd turn(2.0 * EIGEN_PI * options_.number / options_.count, Eigen::Vector3d::UnitZ());
  return robot * turn * robot.inverse() * first;
}

void SimulatedCamera::render(std::uint32_t index, SimulatedFrame& frame)
{
  frame.index = index;
  frame.time = index / options_.rate;
  frame.camera_to_world = pose(index);
  frame.base_to_world = base(index);
  // The floor is the robot's z = 0: the height of a point p of the camera is the third row of the transform, applied
  // to p.
  const Eigen::Isometry3d camera_to_base = frame.base_to_world.inverse() * frame.camera_to_world;
  frame.floor.normal = camera_to_base.linear().row(2);
  frame.floor.distance = camera_to_base.translation().z();
  caster_.cast(options_.camera, frame.camera_to_world, frame.time, frame.truth);
  noise_.apply(options_.camera, frame.truth, index, frame.depth);

  const Surface stands_on = scene_->groundHeight(frame.base_to_world.translation().head<2>()) == 0.0
                                ? Surface::kFloor
                                : Surface::kGround;
  std::size_t floor_pixels = 0;
  for (std::size_t i = 0; i < frame.depth.size(); ++i)
    floor_pixels += static_cast<std::size_t>(frame.truth.surface[i] == stands_on && frame.depth[i] > 0.0F);
  frame.floor_fraction = static_cast<double>(floor_pixels) / static_cast<double>(frame.depth.size());
}

void toMillimetres(const std::vector<float>& depth, std::uint16_t* millimetres)
{
  for (const float z : depth) {
    const float rounded = 1000.0F * z + 0.5F;
    // Written so that NaN fails.
    *millimetres++ =
        rounded >= 1.0F && rounded < 65536.0F ? static_cast<std::uint16_t>(rounded) : std::uint16_t{0};
  }
}

}  // namespace polygonal_perception::simulation

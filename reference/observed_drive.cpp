#include "reference/observed_drive.hpp"

#include <cmath>

#include "polygonal_perception/cameras/simulation/simulated_camera.hpp"
#include "polygonal_perception/perception/pipeline.hpp"

namespace polygonal_perception::reference {

std::vector<ObservedFrame> observedDrive()
{
  constexpr std::uint32_t kFrames = 100;
  simulation::SimulatedCamera::Options options;
  options.scene = "busy_office";
  options.rate = 3.0;
  simulation::SimulatedCamera camera(options);
  const simulation::PinholeCamera& pinhole = options.camera;
  const auto rays = perception::PinholeRays::make(pinhole.width, pinhole.height, pinhole.fx, pinhole.fy,
                                                  pinhole.cx, pinhole.cy);
  perception::Pipeline pipeline({});
  simulation::SimulatedFrame frame;
  std::vector<ObservedFrame> recorded;
  for (std::uint32_t index = 0; index < kFrames; ++index) {
    camera.render(index, frame);
    const auto points = perception::PointView::depth(frame.depth.data(), pinhole.width * sizeof(float), rays);
    const auto& result = pipeline.process({points, frame.time, {}}, perception::Product::kLookedThrough);
    if (result.floor.status != perception::FloorStatus::kFound) continue;
    const Eigen::Isometry3d floor_to_world = frame.camera_to_world * result.to_floor_frame.inverse();
    ObservedFrame& one = recorded.emplace_back();
    one.geometry = result.occupancy.geometry();
    one.cells = result.observed;
    one.pose = Eigen::Translation2d(floor_to_world.translation().head<2>()) *
               Eigen::Rotation2Dd(std::atan2(floor_to_world(1, 0), floor_to_world(0, 0)));
    one.robot = frame.base_to_world.translation().head<2>();
  }
  return recorded;
}

}  // namespace polygonal_perception::reference

#include "occupancy_frames.hpp"

#include <random>

#include "polygonal_perception/cameras/simulation/simulated_camera.hpp"
#include "polygonal_perception/perception/pipeline.hpp"
#include "reference/random_grids.hpp"
#include "reference/recorded_frames.hpp"

namespace polygonal_perception::evaluation {

namespace {

void add(perception::Pipeline& pipeline, const perception::PointView& view, double stamp, OccupancySet& set)
{
  perception::Frame frame;
  frame.points = view;
  frame.stamp = stamp;
  const perception::Pipeline::Result& result = pipeline.process(frame, perception::Product::kOccupancy);
  if (result.floor.status != perception::FloorStatus::kNotFound) set.grids.push_back(result.occupancy);
}

}  // namespace

OccupancySet renderOccupancy(const std::string& scene, int drives, int frames_each)
{
  constexpr std::uint32_t kEvery = 10;  // frames at 30 Hz
  OccupancySet set{scene, {}};
  for (int drive = 0; drive < drives; ++drive) {
    simulation::SimulatedCamera::Options options;
    options.scene = scene;
    options.seed = 1 + static_cast<std::uint64_t>(drive);
    simulation::SimulatedCamera camera(options);
    const auto& pinhole = options.camera;
    const perception::PinholeRays rays = perception::PinholeRays::make(
        pinhole.width, pinhole.height, pinhole.fx, pinhole.fy, pinhole.cx, pinhole.cy);
    perception::Pipeline pipeline{perception::Pipeline::Parameters{}};
    simulation::SimulatedFrame frame;
    for (int k = 0; k < frames_each; ++k) {
      camera.render(static_cast<std::uint32_t>(k) * kEvery, frame);
      add(pipeline, perception::PointView::depth(frame.depth.data(), pinhole.width * sizeof(float), rays),
          frame.time, set);
    }
  }
  return set;
}

OccupancySet readOccupancy(const std::string& frames_json)
{
  OccupancySet set{"recorded", {}};
  perception::Pipeline pipeline{perception::Pipeline::Parameters{}};
  double stamp = 0.0;
  for (const reference::RecordedFrame& recorded : reference::listRecordedFrames(frames_json)) {
    const reference::LoadedFrame loaded = reference::load(recorded);
    add(pipeline, loaded.view(), stamp += 1.0 / 30.0, set);
  }
  return set;
}

OccupancySet randomOccupancy(int count)
{
  OccupancySet set{"random grids", {}};
  std::mt19937 random(1);
  for (int n = 0; n < count; ++n)
    set.grids.push_back(reference::randomGrid(static_cast<unsigned>(n), 100, 100, 0.05, random));
  return set;
}

}  // namespace polygonal_perception::evaluation

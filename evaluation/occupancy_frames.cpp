#include "occupancy_frames.hpp"

#include <random>

#include "polygonal_perception/pipeline.hpp"
#include "polygonal_perception/simulation/simulated_camera.hpp"
#include "random_grids.hpp"
#include "recorded_frames.hpp"

namespace polygonal_perception {
namespace evaluation {

namespace {

void add(Pipeline& pipeline, const PointView& view, double stamp, OccupancySet& set)
{
  Frame frame;
  frame.points = view;
  frame.stamp = stamp;
  const Pipeline::Result& result = pipeline.process(frame, Pipeline::Goal::kOccupancy);
  if (result.floor.status != FloorStatus::kNotFound) set.grids.push_back(result.occupancy);
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
    const PinholeRays rays =
        PinholeRays::make(pinhole.width, pinhole.height, pinhole.fx, pinhole.fy, pinhole.cx, pinhole.cy);
    Pipeline pipeline{Pipeline::Parameters{}};
    simulation::SimulatedFrame frame;
    for (int k = 0; k < frames_each; ++k) {
      camera.render(static_cast<std::uint32_t>(k) * kEvery, frame);
      add(pipeline, PointView::depth(frame.depth.data(), pinhole.width * sizeof(float), rays), frame.time,
          set);
    }
  }
  return set;
}

OccupancySet readOccupancy(const std::string& frames_json)
{
  OccupancySet set{"recorded", {}};
  Pipeline pipeline{Pipeline::Parameters{}};
  double stamp = 0.0;
  for (const RecordedFrame& recorded : listRecordedFrames(frames_json)) {
    const LoadedFrame loaded = load(recorded);
    add(pipeline, loaded.view(), stamp += 1.0 / 30.0, set);
  }
  return set;
}

OccupancySet randomOccupancy(int count)
{
  OccupancySet set{"random grids", {}};
  std::mt19937 random(1);
  for (int n = 0; n < count; ++n)
    set.grids.push_back(randomGrid(static_cast<unsigned>(n), 100, 100, 0.05, random));
  return set;
}

}  // namespace evaluation
}  // namespace polygonal_perception

#include <gtest/gtest.h>

#include "polygonal_perception/cameras/simulation/simulated_camera.hpp"
#include "polygonal_perception/perception/floor/floor_tracker.hpp"
#include "reference/error_statistics.hpp"

namespace polygonal_perception::test {
namespace {

using simulation::SimulatedCamera;
using simulation::SimulatedFrame;

constexpr double kEnoughFloor = 0.02;  // of the image, as the contract counts
constexpr std::uint64_t kSeed = 101;   // none that anything was tuned to

struct Errors
{
  std::vector<double> degrees;
  std::vector<double> millimetres;
  int frames = 0;
  int missed = 0;

  void append(const Errors& other)
  {
    degrees.insert(degrees.end(), other.degrees.begin(), other.degrees.end());
    millimetres.insert(millimetres.end(), other.millimetres.begin(), other.millimetres.end());
    frames += other.frames;
    missed += other.missed;
  }
};

/// Renders frames and tells a wrong plane as a failure.
/// @param independent    each frame starts from the initial up vector
/// @param known_height   the camera's height is bounded to 25 cm, as a robot's is
Errors run(const std::string& scene, const std::string& trajectory, int frames, bool independent,
           bool known_height)
{
  simulation::SimulatedCamera::Options options;
  options.scene = scene;
  options.trajectory = trajectory;
  options.seed = kSeed;
  simulation::SimulatedCamera camera(options);
  const auto& pinhole = options.camera;
  const perception::PinholeRays rays = perception::PinholeRays::make(
      pinhole.width, pinhole.height, pinhole.fx, pinhole.fy, pinhole.cx, pinhole.cy);

  perception::FloorDetector::Parameters detector;
  perception::FloorTracker tracker({}, detector);
  perception::SampleGrid grid{perception::SampleGrid::Parameters{}};
  simulation::SimulatedFrame frame;
  Errors errors;
  for (int k = 0; k < frames; ++k) {
    camera.render(static_cast<std::uint32_t>(k), frame);
    if (known_height) {
      detector.max_camera_height = frame.floor.distance + 0.25;
      tracker.configure({}, detector);
    }
    if (independent) tracker.reset();
    const perception::PointView view =
        perception::PointView::depth(frame.depth.data(), pinhole.width * sizeof(float), rays);
    grid.update(view);
    const perception::FloorState& state = tracker.update(view, grid, frame.time, std::nullopt);
    if (frame.floor_fraction < kEnoughFloor) continue;
    ++errors.frames;
    if (state.status != perception::FloorStatus::kFound) {
      ++errors.missed;
      continue;
    }
    const geometry::Plane& found = state.floor.plane;
    EXPECT_FALSE(reference::isWrong(found, frame.floor))
        << scene << ", " << trajectory << ", frame " << k << ": "
        << reference::normalError(found, frame.floor) << " deg, "
        << reference::heightError(found, frame.floor) << " mm off, " << 100 * frame.floor_fraction
        << " % floor, true height " << frame.floor.distance << ", found " << found.distance;
    errors.degrees.push_back(reference::normalError(found, frame.floor));
    errors.millimetres.push_back(reference::heightError(found, frame.floor));
  }
  return errors;
}

void expectContract(const Errors& errors)
{
  EXPECT_LE(reference::quantile(errors.degrees, 0.5), 0.05);
  EXPECT_LE(reference::quantile(errors.degrees, 0.95), 0.4);
  EXPECT_LE(reference::quantile(errors.millimetres, 0.5), 2.0);
  EXPECT_LE(reference::quantile(errors.millimetres, 0.95), 10.0);
  EXPECT_LE(errors.missed, errors.frames / 50) << "of " << errors.frames;
}

const std::vector<std::string> kLevelScenes = {"corridor",  "office", "person",
                                               "table_top", "wall",   "doorway"};

TEST(RenderedFloors, KeepTheContractFromTheInitialUpVectorAlone)
{
  Errors all;
  for (const auto& scene : kLevelScenes) {
    for (const char* trajectory : {"independent_low", "independent_high"}) {
      all.append(run(scene, trajectory, 20, true, false));
    }
  }
  expectContract(all);
}

TEST(RenderedFloors, KeepTheContractOverASequence)
{
  Errors all;
  for (const auto& scene : kLevelScenes) {
    for (const char* trajectory : {"smooth_low", "smooth_high", "nao", "robotino"}) {
      all.append(run(scene, trajectory, 10, false, false));
    }
  }
  expectContract(all);
}

TEST(RenderedFloors, AboveALedgeAreTheRobotsOwnWhereTheCamerasHeightIsKnown)
{
  Errors all;
  for (const char* trajectory : {"smooth_low", "smooth_high", "nao", "robotino"}) {
    all.append(run("ledge", trajectory, 15, false, true));
  }
  all.append(run("ledge", "independent_low", 20, true, true));
  all.append(run("ledge", "independent_high", 20, true, true));
  expectContract(all);
}

TEST(RenderedFloors, AboveStairsAreTheRobotsOwnWhereTheCamerasHeightIsKnown)
{
  Errors all;
  for (const char* trajectory : {"smooth_low", "smooth_high", "nao", "robotino"}) {
    all.append(run("stairs", trajectory, 15, false, true));
  }
  expectContract(all);
}

}  // namespace
}  // namespace polygonal_perception::test

#include <gtest/gtest.h>

#include "douglas_peucker.hpp"
#include "polygon_checker.hpp"
#include "polygonal_perception/pipeline.hpp"
#include "polygonal_perception/simulation/simulated_camera.hpp"
#include "recorded_frames.hpp"

namespace polygonal_perception {
namespace {

/// The defaults, in cells: robot_radius 0.30 m, simplification_tolerance 0.05 m, 0.05 m a cell.
constexpr CellLength kRadius{6, 1};
constexpr CellLength kLimit{17, 2};

constexpr double kTolerance = 1.0;  // [cells]

/// Checks clauses 1 to 4 in each frame and clause 5 over all frames.
class FramePolygonsTest : public ::testing::Test
{
protected:
  void check(Pipeline& pipeline, const PointView& view, double stamp, const std::string& name)
  {
    const Pipeline::Result& result = pipeline.process({view, stamp, {}});
    const auto fault = PolygonChecker(result.occupancy, result.polygons, kRadius, kLimit).fault();
    EXPECT_FALSE(fault) << name << ": " << *fault;
    if (result.floor.status != FloorStatus::kNotFound) ++with_floor_;
    vertices_ += result.polygons.vertices.size();
    vertices_of_douglas_peucker_ += verticesOfDouglasPeucker(result.inflated, kTolerance);
  }
  void TearDown() override
  {
    EXPECT_LE(static_cast<double>(vertices_), 1.2 * static_cast<double>(vertices_of_douglas_peucker_));
  }

  int with_floor_ = 0;

private:
  std::size_t vertices_ = 0;
  std::size_t vertices_of_douglas_peucker_ = 0;
};

TEST_F(FramePolygonsTest, OfRecordedFramesKeepTheContract)
{
  const auto path = findRecordedFrames();
  if (!path)
    GTEST_SKIP() << "no recorded frames: set POLYGONAL_PERCEPTION_DATA to a folder with a frames.json";
  Pipeline pipeline{Pipeline::Parameters{}};
  double stamp = 0.0;
  for (const RecordedFrame& frame : listRecordedFrames(*path)) {
    const LoadedFrame loaded = load(frame);
    stamp += 1.0 / 30.0;
    check(pipeline, loaded.view(), stamp, frame.name);
  }
  EXPECT_GT(with_floor_, 70);
}

TEST_F(FramePolygonsTest, OfRenderedFramesKeepTheContract)
{
  for (const std::string& scene : simulation::sceneNames()) {
    simulation::SimulatedCamera::Options options;
    options.scene = scene;
    options.trajectory = "robotino";
    options.seed = 102;
    simulation::SimulatedCamera camera(options);
    const auto& pinhole = options.camera;
    const PinholeRays rays =
        PinholeRays::make(pinhole.width, pinhole.height, pinhole.fx, pinhole.fy, pinhole.cx, pinhole.cy);
    Pipeline pipeline{Pipeline::Parameters{}};
    simulation::SimulatedFrame frame;
    for (std::uint32_t k = 0; k < 60; k += 15) {
      camera.render(k, frame);
      const PointView view = PointView::depth(frame.depth.data(), pinhole.width * sizeof(float), rays);
      check(pipeline, view, frame.time, scene + ", frame " + std::to_string(k));
    }
  }
  EXPECT_GT(with_floor_, 20);
}

}  // namespace
}  // namespace polygonal_perception

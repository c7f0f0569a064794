#include <gtest/gtest.h>

#include "polygonal_perception/cameras/simulation/simulated_camera.hpp"
#include "polygonal_perception/perception/pipeline.hpp"
#include "reference/douglas_peucker.hpp"
#include "reference/polygon_checker.hpp"
#include "reference/recorded_frames.hpp"

namespace polygonal_perception::test {
namespace {

/// The defaults, in cells: robot_radius 0.30 m, simplification_tolerance 0.05 m, 0.05 m a cell.
constexpr reference::CellLength kRadius{6, 1};
constexpr reference::CellLength kLimit{17, 2};

constexpr double kTolerance = 1.0;  // [cells]

/// Checks clauses 1 to 4 in each frame and clause 5 over all frames.
class FramePolygonsTest : public ::testing::Test
{
protected:
  void check(perception::Pipeline& pipeline, const perception::PointView& view, double stamp,
             const std::string& name)
  {
    const perception::Pipeline::Result& result = pipeline.process({view, stamp, {}});
    const auto fault = reference::PolygonChecker(result.occupancy, result.polygons, kRadius, kLimit).fault();
    EXPECT_FALSE(fault) << name << ": " << *fault;
    if (result.floor.status != perception::FloorStatus::kNotFound) ++with_floor_;
    vertices_ += result.polygons.vertices.size();
    vertices_of_douglas_peucker_ += reference::verticesOfDouglasPeucker(result.inflated, kTolerance);
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
  const auto path = reference::findRecordedFrames();
  if (!path)
    GTEST_SKIP() << "no recorded frames: set POLYGONAL_PERCEPTION_DATA to a folder with a frames.json";
  perception::Pipeline pipeline{perception::Pipeline::Parameters{}};
  double stamp = 0.0;
  for (const reference::RecordedFrame& frame : reference::listRecordedFrames(*path)) {
    const reference::LoadedFrame loaded = reference::load(frame);
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
    const perception::PinholeRays rays = perception::PinholeRays::make(
        pinhole.width, pinhole.height, pinhole.fx, pinhole.fy, pinhole.cx, pinhole.cy);
    perception::Pipeline pipeline{perception::Pipeline::Parameters{}};
    simulation::SimulatedFrame frame;
    for (std::uint32_t k = 0; k < 60; k += 15) {
      camera.render(k, frame);
      const perception::PointView view =
          perception::PointView::depth(frame.depth.data(), pinhole.width * sizeof(float), rays);
      check(pipeline, view, frame.time, scene + ", frame " + std::to_string(k));
    }
  }
  EXPECT_GT(with_floor_, 20);
}

}  // namespace
}  // namespace polygonal_perception::test

// The planes of rendered frames against those of their scenes. doc/planes.md says what of the contract holds and what does
// not; here what holds is held.
#include <gtest/gtest.h>

#include <algorithm>

#include "polygonal_perception/cameras/simulation/simulated_camera.hpp"
#include "polygonal_perception/perception/pipeline.hpp"
#include "reference/error_statistics.hpp"
#include "reference/plane_checker.hpp"

namespace polygonal_perception::test {
namespace {

constexpr std::uint64_t kSeed = 101;  // none that anything was tuned to
constexpr int kFrames = 4;

reference::PlaneCounts run(const std::string& scene, const std::string& trajectory)
{
  simulation::SimulatedCamera::Options options;
  options.scene = scene;
  options.trajectory = trajectory;
  options.seed = kSeed;
  simulation::SimulatedCamera camera(options);
  const auto& pinhole = options.camera;
  const perception::PinholeRays rays = perception::PinholeRays::make(
      pinhole.width, pinhole.height, pinhole.fx, pinhole.fy, pinhole.cx, pinhole.cy);
  const perception::Pipeline::Parameters parameters;
  perception::Pipeline pipeline(parameters);
  reference::PlaneChecker checker(camera, parameters.samples.samples_x, parameters.samples.samples_y);
  simulation::SimulatedFrame frame;
  for (std::uint32_t k = 0; k < kFrames; ++k) {
    camera.render(k, frame);
    const perception::PointView view =
        perception::PointView::depth(frame.depth.data(), pinhole.width * sizeof(float), rays);
    checker.add(frame, pipeline.process({view, frame.time, {}}, perception::Product::kPlanes).planes);
  }
  return checker.counts();
}

std::string listed(const std::vector<std::string>& faults)
{
  std::string text;
  for (const std::string& fault : faults) text += "\n  " + fault;
  return text;
}

class RenderedPlanes : public testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    counts_ = {};
    for (const std::string scene : {"office", "doorway", "stairs", "kerb", "threshold", "dais", "ramp"}) {
      for (const std::string trajectory : {"robotino", "smooth_low", "smooth_high"})
        counts_.add(run(scene, trajectory));
    }
  }

  static reference::PlaneCounts counts_;
};

reference::PlaneCounts RenderedPlanes::counts_;

TEST_F(RenderedPlanes, AreFoundAndNotSplit)
{
  ASSERT_GT(counts_.true_ones, 200);
  EXPECT_GE(counts_.found, 0.87 * counts_.true_ones) << "of " << counts_.true_ones << listed(counts_.faults);
  EXPECT_LE(counts_.split, 0.01 * counts_.true_ones) << listed(counts_.faults);
  EXPECT_LE(counts_.invented, 0.08 * counts_.listed) << "of " << counts_.listed << listed(counts_.faults);
}

TEST_F(RenderedPlanes, LieWhereTheTrueOnesDo)
{
  EXPECT_LE(reference::quantile(counts_.degrees, 0.5), 0.1);
  EXPECT_LE(reference::quantile(counts_.degrees, 0.9), 1.0);
  EXPECT_LE(reference::quantile(counts_.millimetres, 0.5), 1.0);
  EXPECT_LE(reference::quantile(counts_.millimetres, 0.9), 10.0);
}

TEST_F(RenderedPlanes, KeepTheirIds)
{
  ASSERT_GT(counts_.pairs, 150);
  EXPECT_GE(counts_.kept, 0.95 * counts_.pairs) << "of " << counts_.pairs;
}

}  // namespace
}  // namespace polygonal_perception::test

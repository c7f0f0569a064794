// The contract Scan: no bin ends on the floor however a walking camera shakes, a bin's range is that of the nearest
// obstacle, and nothing is cleared through one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "polygonal_perception/cameras/simulation/simulated_camera.hpp"
#include "polygonal_perception/perception/pipeline.hpp"

namespace polygonal_perception {
namespace {

using simulation::Surface;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Bins of all frames together.
struct Counts
{
  std::size_t frames = 0;
  std::size_t ranges = 0;
  std::size_t clear = 0;       // +inf
  std::size_t on_floor = 0;    // ranges at which only floor was measured
  std::size_t too_far = 0;     // ranges beyond an obstacle that is plainly seen
  std::size_t through = 0;     // +inf through one
  std::size_t missed = 0;      // NaN though one is plainly seen
  std::size_t unseen = 0;      // +inf where no floor was measured near the end
  std::vector<double> errors;  // [m]
};

class ScanFrame
{
public:
  ScanFrame(const simulation::SimulatedFrame& frame, const perception::PinholeRays& rays,
            const perception::Pipeline& pipeline)
      : frame_(frame), rays_(rays), result_(pipeline.result()), heights_(pipeline.parameters().projection)
  {
    const std::uint32_t count = scan().bins.count;
    nearest_.assign(count, kInfinity);
    plain_.assign(count, 0);
    measured_.resize(count);
    farthest_floor_.assign(count, 0.0F);
    for (std::size_t k = 0; k < frame.depth.size(); ++k) {
      if (frame.depth[k] > 0.0F && frame.truth.surface[k] != Surface::kNone) add(k);
    }
  }

  void addTo(Counts& counts) const
  {
    ++counts.frames;
    for (std::uint32_t bin = 0; bin < scan().bins.count; ++bin) {
      const float range = scan().ranges[bin];
      // Plainly seen: by several pixels that noise has not moved, here and not only in a corner of the bin.
      const float obstacle = plain_[bin] >= 5 ? nearest_[bin] : kInfinity;
      const bool is_near = obstacle + tolerance(obstacle) < scan().range_max;
      if (std::isnan(range)) {
        counts.missed += is_near ? 1 : 0;
      } else if (range == kInfinity) {
        ++counts.clear;
        counts.through += is_near ? 1 : 0;
        counts.unseen += farthestFloorAround(bin) < 0.9 * scan().range_max ? 1 : 0;
      } else {
        ++counts.ranges;
        counts.too_far += range > obstacle + tolerance(obstacle) ? 1 : 0;
        counts.on_floor += isMeasuredAround(bin, range) ? 0 : 1;
        if (plain_[bin] >= 5) counts.errors.push_back(std::abs(range - obstacle));
      }
    }
  }

private:
  const perception::LevelScan& scan() const { return result_.scan; }

  /// [m] Of the camera.
  static double sigma(double range)
  {
    const double beyond = std::max(0.0, range - 0.4);
    return 0.0012 + 0.0019 * beyond * beyond;
  }
  static double disparityStep(double range) { return range * range / 348.0; }

  /// [m] 1.5 cells, 3 sigma of the camera and half a disparity step.
  static double tolerance(double range)
  {
    return 1.5 * 0.05 + 3.0 * sigma(range) + 0.5 * disparityStep(range);
  }
  /// Whether a depth is what no noise makes of the true one.
  static bool isMixed(double depth, double truth)
  {
    return std::abs(depth - truth) > 5.0 * sigma(truth) + disparityStep(truth);
  }

  /// The bin of a point in the optical frame, or -1.
  int binOf(const Eigen::Vector3d& on_floor) const
  {
    const perception::BearingBins& bins = scan().bins;
    const double bin =
        std::floor((std::atan2(on_floor.y(), on_floor.x()) - bins.first) / bins.increment + 0.5);
    return bin >= 0.0 && bin < bins.count ? static_cast<int>(bin) : -1;
  }

  void add(std::size_t k)
  {
    constexpr double kMargin = 0.01;  // [m]
    const std::size_t columns = rays_.column_slope.size();
    const Eigen::Vector3d ray(rays_.column_slope[k % columns], rays_.row_slope[k / columns], 1.0);
    const Eigen::Vector3d measured = result_.to_floor_frame * (frame_.depth[k] * ray);
    const Eigen::Vector3d truth = result_.to_floor_frame * (frame_.truth.depth[k] * ray);
    const double true_height = frame_.floor.height(frame_.truth.depth[k] * ray);
    const double height = frame_.floor.height(frame_.depth[k] * ray);
    const int bin = binOf(measured);
    if (bin < 0) return;
    const auto at = static_cast<std::size_t>(bin);
    const auto range = static_cast<float>(measured.head<2>().norm());
    const auto true_range = static_cast<float>(truth.head<2>().norm());
    if (frame_.truth.surface[k] == Surface::kFloor) {
      farthest_floor_[at] = std::max(farthest_floor_[at], range);
      // At a border of depths a pixel of the floor measures something in between, which no noise does.
      if (isMixed(frame_.depth[k], frame_.truth.depth[k])) measured_[at].push_back(range);
      return;
    }
    measured_[at].push_back(range);
    const auto stands = [&](double h) {
      return h > heights_.min_height + kMargin && h < heights_.max_height - kMargin;
    };
    // A pixel at a border of depths measures something in between: its range is nobody's.
    if (!stands(height) || !stands(true_height) || std::abs(range - true_range) > tolerance(true_range))
      return;
    nearest_[at] = std::min(nearest_[at], true_range);
    ++plain_[at];
  }

  bool isMeasuredAround(std::uint32_t bin, float range) const
  {
    for (std::uint32_t b = bin == 0 ? 0 : bin - 1; b <= std::min(bin + 1, scan().bins.count - 1); ++b) {
      for (const float measured : measured_[b]) {
        if (std::abs(measured - range) < 0.01F) return true;
      }
    }
    return false;
  }
  float farthestFloorAround(std::uint32_t bin) const
  {
    float farthest = farthest_floor_[bin];
    if (bin > 0) farthest = std::max(farthest, farthest_floor_[bin - 1]);
    if (bin + 1 < farthest_floor_.size()) farthest = std::max(farthest, farthest_floor_[bin + 1]);
    return farthest;
  }

  const simulation::SimulatedFrame& frame_;
  const perception::PinholeRays& rays_;
  const perception::Pipeline::Result& result_;
  const perception::Projection::Parameters& heights_;
  std::vector<float> nearest_;                // [m] by bin: the true range of what is plainly seen,
  std::vector<int> plain_;                    // and by how many pixels it is
  std::vector<std::vector<float>> measured_;  // [m] of all but the floor
  std::vector<float> farthest_floor_;         // [m]
};

void drive(const std::string& scene, const std::string& trajectory, std::uint32_t frames, Counts& counts)
{
  simulation::SimulatedCamera::Options options;
  options.scene = scene;
  options.trajectory = trajectory;
  options.seed = 17;
  options.camera = simulation::PinholeCamera::ofSize(320, 240);
  simulation::SimulatedCamera camera(options);
  const simulation::PinholeCamera& pinhole = options.camera;
  const auto rays = perception::PinholeRays::make(pinhole.width, pinhole.height, pinhole.fx, pinhole.fy,
                                                  pinhole.cx, pinhole.cy);
  perception::Pipeline pipeline({});
  simulation::SimulatedFrame frame;
  for (std::uint32_t index = 0; index < frames; ++index) {
    camera.render(3 * index, frame);
    constexpr double kEnoughFloor = 0.02;  // see the floor's contract
    if (frame.floor_fraction < kEnoughFloor) continue;
    pipeline.process({perception::PointView::depth(frame.depth.data(), pinhole.width * sizeof(float), rays),
                      frame.time,
                      {}},
                     perception::Product::kScan);
    if (pipeline.result().floor.status == perception::FloorStatus::kFound)
      ScanFrame(frame, rays, pipeline).addTo(counts);
  }
}

TEST(Scan, AWalkingCameraSeesWhatALevelLaserWould)
{
  Counts all;
  for (const char* scene : {"corridor", "office", "busy_office", "person", "doorway"}) {
    drive(scene, "nao", 200, all);
    drive(scene, "robotino", 20, all);
    drive(scene, "smooth_lowest", 10, all);
    drive(scene, "smooth_high", 10, all);
  }
  std::sort(all.errors.begin(), all.errors.end());
  ASSERT_GT(all.errors.size(), 10000U);
  std::printf(
      "%zu frames, %zu ranges, %zu clear; on the floor %zu, beyond an obstacle %zu, clear through one %zu, "
      "clear "
      "over unseen floor %zu, missed %zu; error median %.3f m, 95 %% %.3f m\n",
      all.frames, all.ranges, all.clear, all.on_floor, all.too_far, all.through, all.unseen, all.missed,
      all.errors[all.errors.size() / 2], all.errors[all.errors.size() * 95 / 100]);
  EXPECT_GE(all.frames, 1000U);
  EXPECT_EQ(all.on_floor, 0U);
  EXPECT_EQ(all.through, 0U);
  EXPECT_EQ(all.unseen, 0U);
  EXPECT_GT(all.clear, 1000U);
  EXPECT_LE(all.too_far + all.missed, all.ranges / 1000);
}

}  // namespace
}  // namespace polygonal_perception

// The contract Observed: what is called seen free was seen, and holds nothing; what was seen is called so.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "polygonal_perception/cameras/simulation/simulated_camera.hpp"
#include "polygonal_perception/perception/pipeline.hpp"

namespace polygonal_perception {
namespace {

using simulation::Surface;

/// Cells of all frames together.
struct Counts
{
  std::size_t free = 0;       // called seen free,
  std::size_t holding = 0;    // and hold a plainly visible part of an obstacle
  std::size_t unseen = 0;     // and have no measured point of the floor in them or beside them
  std::size_t seen = 0;       // in which at least four pixels of the floor lie and nothing else,
  std::size_t seen_free = 0;  // and are called so
};

class ObservedFrame
{
public:
  ObservedFrame(const simulation::SimulatedFrame& frame, const perception::PinholeRays& rays,
                const perception::Pipeline& pipeline)
      : frame_(frame), rays_(rays), result_(pipeline.result()), heights_(pipeline.parameters().projection)
  {
    const std::size_t size = grid().size();
    floor_.assign(size, 0);
    low_.assign(size, 0);
    obstacle_.assign(size, 0);
    plain_.assign(size, 0);
    for (std::size_t k = 0; k < frame.depth.size(); ++k) {
      if (frame.depth[k] > 0.0F && frame.truth.surface[k] != Surface::kNone) add(k);
    }
  }

  void addTo(Counts& counts) const
  {
    const int columns = grid().cells_x;
    for (int j = 0; j < grid().cells_y; ++j) {
      for (int i = 0; i < columns; ++i) {
        const auto cell = static_cast<std::size_t>(j * columns + i);
        const bool is_free = result_.occupancy.cells()[cell] == 0 && result_.observed.floor[cell] != 0;
        const bool is_seen = floor_[cell] >= 4 && obstacle_[cell] == 0;
        counts.free += is_free ? 1 : 0;
        counts.holding += is_free && plain_[cell] != 0 ? 1 : 0;
        counts.unseen += is_free && !isLowAround(i, j) ? 1 : 0;
        counts.seen += is_seen ? 1 : 0;
        counts.seen_free += is_seen && is_free ? 1 : 0;
      }
    }
  }

private:
  const occupancy::GridGeometry& grid() const { return result_.occupancy.geometry(); }

  /// The row-major index of the cell of a point of the floor frame, or -1.
  int cellOf(const Eigen::Vector3d& point) const
  {
    const int i = static_cast<int>(std::floor((point.x() - grid().origin_x) / grid().resolution));
    const int j = static_cast<int>(std::floor((point.y() - grid().origin_y) / grid().resolution));
    return i >= 0 && i < grid().cells_x && j >= 0 && j < grid().cells_y ? j * grid().cells_x + i : -1;
  }

  /// The true height above the floor of a point in the optical frame.
  double heightOf(const Eigen::Vector3d& point) const { return frame_.floor.height(point); }

  void add(std::size_t k)
  {
    constexpr double kMargin = 0.01;  // [m]
    const std::size_t columns = rays_.column_slope.size();
    const Eigen::Vector3d ray(rays_.column_slope[k % columns], rays_.row_slope[k / columns], 1.0);
    const Eigen::Vector3d measured = frame_.depth[k] * ray;
    const Eigen::Vector3d truth = frame_.truth.depth[k] * ray;
    const int cell = cellOf(result_.to_floor_frame * measured);
    const int true_cell = cellOf(result_.to_floor_frame * truth);
    const double height = heightOf(measured);
    const double true_height = heightOf(truth);
    const auto stands = [&](double h, double margin) {
      return h > heights_.min_height + margin && h < heights_.max_height - margin;
    };
    const bool is_floor = frame_.truth.surface[k] == Surface::kFloor;
    if (cell >= 0) {
      const auto at = static_cast<std::size_t>(cell);
      low_[at] |= std::abs(height) < heights_.min_height + kMargin ? 1 : 0;
      floor_[at] += is_floor && std::abs(height) < heights_.min_height ? 1 : 0;
      obstacle_[at] |= stands(height, -kMargin) ? 1 : 0;
      plain_[at] |=
          !is_floor && cell == true_cell && stands(height, kMargin) && stands(true_height, kMargin) ? 1 : 0;
    }
    if (true_cell >= 0 && !is_floor && stands(true_height, -2.0 * kMargin))
      obstacle_[static_cast<std::size_t>(true_cell)] = 1;
  }

  bool isLowAround(int i, int j) const
  {
    for (int y = std::max(0, j - 1); y <= std::min(grid().cells_y - 1, j + 1); ++y) {
      for (int x = std::max(0, i - 1); x <= std::min(grid().cells_x - 1, i + 1); ++x) {
        if (low_[static_cast<std::size_t>(y * grid().cells_x + x)] != 0) return true;
      }
    }
    return false;
  }

  const simulation::SimulatedFrame& frame_;
  const perception::PinholeRays& rays_;
  const perception::Pipeline::Result& result_;
  const perception::Projection::Parameters& heights_;
  std::vector<int> floor_;     // a cell: how many measured points of the floor lie in it
  std::vector<int> low_;       // whether a measured point near the floor does
  std::vector<int> obstacle_;  // whether a true or measured point of an obstacle does
  std::vector<int> plain_;     // whether one does that noise has not moved
};

Counts observe(const std::string& scene, const std::string& trajectory, std::uint64_t seed)
{
  simulation::SimulatedCamera::Options options;
  options.scene = scene;
  options.trajectory = trajectory;
  options.seed = seed;
  options.camera = simulation::PinholeCamera::ofSize(320, 240);
  simulation::SimulatedCamera camera(options);
  const simulation::PinholeCamera& pinhole = options.camera;
  const auto rays = perception::PinholeRays::make(pinhole.width, pinhole.height, pinhole.fx, pinhole.fy,
                                                  pinhole.cx, pinhole.cy);
  perception::Pipeline pipeline({});
  simulation::SimulatedFrame frame;
  Counts counts;
  for (std::uint32_t index = 0; index < 150; index += 15) {
    camera.render(index, frame);
    // With less of it in view a pavement may be taken for the floor: see the floor's contract.
    constexpr double kEnoughFloor = 0.02;
    if (frame.floor_fraction < kEnoughFloor) continue;
    pipeline.process({perception::PointView::depth(frame.depth.data(), pinhole.width * sizeof(float), rays),
                      frame.time,
                      {}},
                     perception::Product::kObserved);
    if (pipeline.result().floor.status == perception::FloorStatus::kFound)
      ObservedFrame(frame, rays, pipeline).addTo(counts);
  }
  return counts;
}

TEST(Observed, WhatIsSeenFreeWasSeenAndIsFree)
{
  Counts all;
  for (const char* scene : {"corridor", "office", "busy_office", "person", "doorway", "pallet", "kerb"}) {
    for (const char* trajectory : {"robotino", "nao", "smooth_lowest", "smooth_high"}) {
      const Counts counts = observe(scene, trajectory, 16);
      all.free += counts.free;
      all.holding += counts.holding;
      all.unseen += counts.unseen;
      all.seen += counts.seen;
      all.seen_free += counts.seen_free;
    }
  }
  std::printf("of %zu free cells %zu hold something and %zu were not seen; of %zu seen cells %zu are free\n",
              all.free, all.holding, all.unseen, all.seen, all.seen_free);
  EXPECT_GT(all.free, 200000U);
  EXPECT_LE(all.holding, all.free / 1000);
  EXPECT_LE(all.unseen, all.free / 1000);
  EXPECT_GE(static_cast<double>(all.seen_free), 0.98 * static_cast<double>(all.seen));
}

}  // namespace
}  // namespace polygonal_perception

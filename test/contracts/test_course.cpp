// A robot drives over ramps, through a door and up to a wall, in the simulated camera: each frame against the truth.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "reference/course_run.hpp"

namespace polygonal_perception::reference {
namespace {

using perception::FloorStatus;

constexpr std::uint32_t kThere = 450;  // frames until the robot stands before the wall at the end

struct Counts
{
  std::array<int, 4> statuses{};
  int off = 0;
  int with_false_cells = 0;
  int obstacle_cells = 0;
  int missed_cells = 0;

  int of(FloorStatus status) const { return statuses[static_cast<std::size_t>(status)]; }
  std::string text() const
  {
    return std::to_string(of(FloorStatus::kFound)) + " FOUND, " + std::to_string(of(FloorStatus::kHeld)) +
           " HELD, " + std::to_string(of(FloorStatus::kAssumed)) + " ASSUMED, " +
           std::to_string(of(FloorStatus::kNotFound)) + " NOT_FOUND; floor off in " + std::to_string(off) +
           ", false cells in " + std::to_string(with_false_cells) + ", " + std::to_string(missed_cells) +
           " of " + std::to_string(obstacle_cells) + " obstacle cells missed";
  }
};

Counts drive(double max_slope, bool has_mount)
{
  CourseRun::Options options;
  options.seed = 3;
  options.has_mount = has_mount;
  options.parameters.ground.max_slope = max_slope;
  CourseRun run(options);
  Counts counts;
  for (std::uint32_t k = 0; k < kThere; ++k) {
    const CourseFrame frame = run.next();
    ++counts.statuses[static_cast<std::size_t>(frame.status)];
    counts.off += frame.isOff() ? 1 : 0;
    counts.with_false_cells += frame.false_cells > 0 ? 1 : 0;
    counts.obstacle_cells += frame.obstacle_cells;
    counts.missed_cells += frame.missed_cells;
  }
  return counts;
}

TEST(Course, WithAMountAndSlopesRampsAreGroundAndTheWallIsSeenToTheEnd)
{
  const Counts counts = drive(0.2, true);
  EXPECT_EQ(counts.of(FloorStatus::kNotFound), 0) << counts.text();
  EXPECT_GT(counts.of(FloorStatus::kAssumed), 50)
      << "where the ramp or the wall fills the view; " << counts.text();
  EXPECT_LE(counts.off, kThere / 50) << counts.text();
  // Before the kerb ramp, which is below the view, what it leads to is a step.
  EXPECT_LE(counts.with_false_cells, kThere / 12) << counts.text();
  EXPECT_GT(counts.obstacle_cells, 10000) << counts.text();
  EXPECT_LE(counts.missed_cells, counts.obstacle_cells / 1000) << counts.text();
}

TEST(Course, WithoutEitherARampIsAnObstacleAndTheFloorIsLostBeforeTheWall)
{
  const Counts counts = drive(0.0, false);
  EXPECT_GT(counts.of(FloorStatus::kNotFound), 10) << counts.text();
  EXPECT_GT(counts.with_false_cells, kThere / 6) << counts.text();
  EXPECT_LE(counts.missed_cells, counts.obstacle_cells / 500) << counts.text();
}

}  // namespace
}  // namespace polygonal_perception::reference

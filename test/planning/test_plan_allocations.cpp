#include <gtest/gtest.h>

#include "polygonal_perception/planning/dynamic_window.hpp"
#include "polygonal_perception/planning/path_planner.hpp"
#include "reference/random_obstacles.hpp"
#include "support/allocation_counter.hpp"

namespace polygonal_perception::test {
namespace {

using Points = std::vector<Eigen::Vector2d>;

constexpr double kSize = 12.0;  // [m]

/// Plans between each two of some places, every second one on the side of the one before.
void planAll(planning::PathPlanner& planner, const Points& places, Points& guide, planning::Plan& plan)
{
  for (const Eigen::Vector2d& start : places) {
    for (const Eigen::Vector2d& goal : places) {
      planner.makePlan(start, goal, 0.5, plan);
      if (plan.outcome == planning::PlanOutcome::kOk) planner.keepSide(0.1, guide, plan);
    }
  }
}

TEST(PlanAllocations, ThereAreNoneOnceWarm)
{
  if (!AllocationCounter::available()) GTEST_SKIP() << "a sanitizer has taken malloc";
  std::mt19937 random(3);
  const auto obstacles = reference::randomObstacles(random, 40, kSize, reference::Raster::kFloat);
  Points places;
  for (int i = 0; i < 12; ++i)
    places.push_back(reference::randomPoint(random, 0.0, kSize, reference::Raster::kFloat));
  planning::PathPlanner planner;
  const Points extent{{-2.0, -2.0}, {kSize + 2.0, -2.0}, {kSize + 2.0, kSize + 2.0}, {-2.0, kSize + 2.0}};
  ASSERT_FALSE(planner.setObstacles(obstacles, extent, false));
  Points guide;
  planning::Plan plan;
  planAll(planner, places, guide, plan);
  planAll(planner, places, guide, plan);
  const AllocationCounter queries;
  planAll(planner, places, guide, plan);
  EXPECT_EQ(queries.count(), 0U);

  const AllocationCounter taking_in;
  ASSERT_FALSE(planner.setObstacles(obstacles, extent, false));
  EXPECT_EQ(taking_in.count(), 0U) << "of polygons that are no larger";
}

TEST(DriveAllocations, ThereAreNoneOnceWarm)
{
  if (!AllocationCounter::available()) GTEST_SKIP() << "a sanitizer has taken malloc";
  std::mt19937 random(3);
  const auto obstacles = reference::randomObstacles(random, 40, kSize, reference::Raster::kFloat);
  std::vector<planning::MovingEdge> standing;
  std::vector<planning::MovingEdge> moving;
  planning::appendMovingEdges(obstacles, Eigen::Vector2d::Zero(), 0.0, standing);
  planning::appendMovingEdges(obstacles, {0.5, 0.2}, 0.1, moving);
  for (planning::MovingEdge& edge : moving) edge.from.x() += kSize;
  const Points path{{0.0, 0.0}, {4.0, 5.0}, {kSize, kSize}};
  planning::DynamicWindow window;
  const auto decideAll = [&] {
    for (double x = 0.0; x < kSize; x += 1.0)
      window.decide({{{x, 0.5 * x}, x}, {0.3, 0.0, 0.1}}, standing, moving, path, 0.0, 0.05);
  };
  decideAll();
  decideAll();
  const AllocationCounter decisions;
  decideAll();
  EXPECT_EQ(decisions.count(), 0U);
}

}  // namespace
}  // namespace polygonal_perception::test

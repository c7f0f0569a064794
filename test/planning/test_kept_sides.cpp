#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "polygonal_perception/geometry/location.hpp"
#include "polygonal_perception/geometry/predicates.hpp"
#include "polygonal_perception/planning/path_search.hpp"
#include "polygonal_perception/planning/side_keeper.hpp"
#include "reference/random_obstacles.hpp"
#include "reference/visibility_graph.hpp"

namespace polygonal_perception::test {
namespace {

using reference::Raster;
using Line = std::vector<Eigen::Vector2d>;

constexpr double kSize = 8.0;  // [m]

/// How often a loop goes round a point that does not lie on it.
int turnsAround(const Line& loop, const Eigen::Vector2d& point)
{
  double angle = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Eigen::Vector2d from = loop[i] - point;
    const Eigen::Vector2d to = loop[(i + 1) % loop.size()] - point;
    angle += std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
  }
  return static_cast<int>(std::lround(angle / (2.0 * M_PI)));
}

/// A point inside of an obstacle, near the middle of a ring's first edge.
Eigen::Vector2d pointInside(const geometry::PolygonSet& obstacles, const geometry::PolygonSet::Ring& ring)
{
  const auto view = obstacles.view(ring);
  const Eigen::Vector2d from = *view.begin();
  const Eigen::Vector2d to = *(view.begin() + 1);
  const Eigen::Vector2d inward(from.y() - to.y(), to.x() - from.x());
  return (from + to) / 2.0 + 1e-4 * inward.normalized();
}

/// Whether a path bends round an obstacle's corner, within whose turn the obstacle lies, or does not bend.
bool isTaut(const geometry::PolygonSet& obstacles, const Eigen::Vector2d& before,
            const Eigen::Vector2d& corner, const Eigen::Vector2d& after)
{
  using geometry::Orientation;
  const Orientation turn = geometry::orientation(before, corner, after);
  if (turn == Orientation::kCollinear) return (after - corner).dot(corner - before) > 0.0;
  const Orientation other =
      turn == Orientation::kClockwise ? Orientation::kCounterClockwise : Orientation::kClockwise;
  for (const auto& ring : obstacles.rings) {
    const auto view = obstacles.view(ring);
    const Eigen::Vector2d* previous = view.end() - 1;
    for (const Eigen::Vector2d& p : view) {
      if (p == corner && geometry::orientation(before, corner, *previous) != other &&
          geometry::orientation(corner, after, *previous) != other)
        return true;
      previous = &p;
    }
  }
  return false;
}

/// What is wrong with a path that is to be homotopic to a line and taut; empty where nothing is.
std::string faultOf(const geometry::PolygonSet& obstacles, const reference::VisibilityGraph& graph,
                    const Line& line, const Line& path)
{
  std::ostringstream fault;
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    if (!graph.sees(path[i], path[i + 1]))
      fault << "cuts an obstacle from " << path[i].transpose() << " to " << path[i + 1].transpose() << "\n";
  Line loop = line;
  loop.insert(loop.end(), path.rbegin(), path.rend());
  for (const auto& ring : obstacles.rings) {
    const int turns = turnsAround(loop, pointInside(obstacles, ring));
    if (turns != 0) fault << "another side of the ring at " << ring.first << " (" << turns << " turns)\n";
  }
  for (std::size_t i = 1; i + 1 < path.size(); ++i)
    if (!isTaut(obstacles, path[i - 1], path[i], path[i + 1]))
      fault << "not taut at " << path[i].transpose() << "\n";
  return fault.str();
}

std::string text(const geometry::PolygonSet& obstacles, const Line& line)
{
  std::ostringstream text;
  text.precision(17);
  text << "along";
  for (const Eigen::Vector2d& p : line) text << " (" << p.transpose() << ")";
  for (const auto& ring : obstacles.rings) {
    text << (ring.hole ? "\nhole" : "\nboundary");
    for (const Eigen::Vector2d& p : obstacles.view(ring)) text << " (" << p.transpose() << ")";
  }
  return text.str();
}

class KeptSides : public testing::TestWithParam<Raster>
{
protected:
  /// Free obstacles, with a search on them and the plain way.
  struct World
  {
    World(std::mt19937& random, std::size_t count, Raster raster)
        : obstacles(reference::randomObstacles(random, count, kSize, raster)), graph(obstacles)
    {
      const auto refused = space.build(obstacles);
      if (refused) throw std::runtime_error(refused->text);
      search.setSpace(space);
    }
    std::optional<planning::FreePlace> randomPlace(std::mt19937& random, Raster raster) const
    {
      return space.locate(reference::randomPoint(random, -2.0, kSize + 2.0, raster));
    }
    geometry::PolygonSet obstacles;
    reference::VisibilityGraph graph;
    planning::FreeSpace space;
    planning::PathSearch search;
  };
};

TEST_P(KeptSides, ASearchsSleeveAndGuideGiveItsPathAgain)
{
  std::mt19937 random(3);
  planning::SideKeeper keeper;
  planning::TautPath taut_path;
  planning::Sleeve sleeve;
  Line path;
  Line again;
  Line guide;
  int paths = 0;
  for (int set = 0; set < 200; ++set) {
    World world(random, 2 + set % 16, GetParam());
    for (int i = 0; i < 25; ++i) {
      const auto start = world.randomPlace(random, GetParam());
      const auto goal = world.randomPlace(random, GetParam());
      if (!start || !goal) continue;
      const auto length = world.search.plan(*start, *goal, path);
      if (!length) continue;
      ++paths;
      world.search.sleeve(sleeve);
      const auto& mesh = world.space.mesh();
      ASSERT_NEAR(taut_path.pull(mesh, sleeve, start->point, goal->point, again), *length,
                  1e-12 * (1.0 + *length))
          << text(world.obstacles, path);
      planning::SideKeeper::makeGuide(mesh, sleeve, path, guide);
      const auto kept = keeper.follow(world.space, *start, *goal, guide, again, sleeve);
      ASSERT_TRUE(kept) << text(world.obstacles, guide);
      ASSERT_NEAR(*kept, *length, 1e-12 * (1.0 + *length)) << text(world.obstacles, guide);
    }
  }
  EXPECT_GT(paths, 2000);
}

TEST_P(KeptSides, ALineAmongObstaclesIsPulledTautOnItsSideOfEach)
{
  std::mt19937 random(5);
  planning::SideKeeper keeper;
  planning::Sleeve sleeve;
  Line first;
  Line second;
  Line path;
  int detours = 0;
  for (int set = 0; set < 200; ++set) {
    World world(random, 2 + set % 16, GetParam());
    for (int i = 0; i < 25; ++i) {
      const auto start = world.randomPlace(random, GetParam());
      const auto between = world.randomPlace(random, GetParam());
      const auto goal = world.randomPlace(random, GetParam());
      if (!start || !between || between->at_origin || !goal) continue;
      const auto there = world.search.plan(*start, *between, first);
      if (!there) continue;
      planning::Sleeve sleeve_there;
      world.search.sleeve(sleeve_there);
      const auto on = world.search.plan(*between, *goal, second);
      if (!on) continue;
      world.search.sleeve(sleeve);
      Line guide;
      Line guide_on;
      planning::SideKeeper::makeGuide(world.space.mesh(), sleeve_there, first, guide);
      planning::SideKeeper::makeGuide(world.space.mesh(), sleeve, second, guide_on);
      guide.insert(guide.end(), guide_on.begin() + 1, guide_on.end());
      planning::SleeveTracer tracer;
      planning::TautPath taut_path;
      if (!tracer.trace(world.space, *start, *goal, guide, sleeve)) {
        ADD_FAILURE() << "no sleeve " << text(world.obstacles, guide);
        return;
      }
      const double length = taut_path.pull(world.space.mesh(), sleeve, start->point, goal->point, path);
      ASSERT_LE(length, *there + *on + 1e-9);
      ASSERT_EQ(faultOf(world.obstacles, world.graph, guide, path), "") << text(world.obstacles, guide);
      const auto shortest = world.search.plan(*start, *goal, first);
      ASSERT_GE(length, *shortest - 1e-9);
      if (length > *shortest + 1e-6) ++detours;
    }
  }
  EXPECT_GT(detours, 200);
}

INSTANTIATE_TEST_SUITE_P(Rasters, KeptSides, testing::Values(Raster::kCoarse, Raster::kFloat));

}  // namespace
}  // namespace polygonal_perception::test

#include <gtest/gtest.h>

#include <optional>
#include <sstream>

#include "polygonal_perception/geometry/location.hpp"
#include "polygonal_perception/planning/path_search.hpp"
#include "reference/minimal_construct.hpp"
#include "reference/random_obstacles.hpp"
#include "reference/visibility_graph.hpp"

namespace polygonal_perception::test {
namespace {

using reference::Raster;

constexpr double kSize = 8.0;  // [m]

struct Query
{
  Eigen::Vector2d start;
  Eigen::Vector2d goal;
};

/// What is wrong with the search's answer; empty where nothing is.
std::string faultOf(const geometry::PolygonSet& obstacles, const reference::VisibilityGraph& graph,
                    const planning::FreeSpace& space, planning::PathSearch& search, const Query& query)
{
  std::ostringstream fault;
  fault.precision(17);
  for (const Eigen::Vector2d& end : {query.start, query.goal}) {
    const bool is_free = geometry::locate(end, obstacles) != geometry::Location::kInside;
    if (space.locate(end).has_value() == is_free) continue;
    fault << end.transpose() << " is " << (is_free ? "free" : "blocked") << ", and was called the other";
    return fault.str();
  }
  const auto start = space.locate(query.start);
  const auto goal = space.locate(query.goal);
  if (!start || !goal) return "";
  std::vector<Eigen::Vector2d> path;
  const std::optional<double> length = search.plan(*start, *goal, path);
  const std::optional<double> shortest = graph.shortest(query.start, query.goal);
  if (length.has_value() != shortest.has_value()) {
    fault << (shortest ? "no path, there is one of " : "a path where there is none, of ")
          << (shortest ? *shortest : *length);
  } else if (length && std::abs(*length - *shortest) > 1e-12 * (1.0 + *shortest)) {
    fault << "a path of " << *length << ", the shortest is " << *shortest;
  } else {
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
      if (!graph.sees(path[i], path[i + 1]))
        fault << "cuts an obstacle from " << path[i].transpose() << " to " << path[i + 1].transpose();
  }
  return fault.str();
}

std::string faultOf(const geometry::PolygonSet& obstacles, const Query& query)
{
  planning::FreeSpace space;
  if (const auto fault = space.build(obstacles)) return fault->text;
  planning::PathSearch search;
  search.setSpace(space);
  return faultOf(obstacles, reference::VisibilityGraph(obstacles), space, search, query);
}

geometry::PolygonSet without(const geometry::PolygonSet& obstacles, std::size_t boundary)
{
  geometry::PolygonSet left;
  bool skips = false;
  for (std::size_t i = 0; i < obstacles.rings.size(); ++i) {
    if (!obstacles.rings[i].hole) skips = i == boundary;
    if (!skips) left.append(obstacles.view(obstacles.rings[i]), obstacles.rings[i].hole);
  }
  return left;
}

/// Takes obstacle after obstacle away as long as a fault stays: what is left shows it best.
std::string shrunk(geometry::PolygonSet obstacles, const Query& query)
{
  for (std::size_t i = 0; i < obstacles.rings.size();) {
    const geometry::PolygonSet fewer = obstacles.rings[i].hole ? obstacles : without(obstacles, i);
    if (fewer.rings.size() < obstacles.rings.size() && !faultOf(fewer, query).empty())
      obstacles = fewer;
    else
      ++i;
  }
  std::ostringstream text;
  text.precision(17);
  text << faultOf(obstacles, query) << "\nfrom " << query.start.transpose() << " to "
       << query.goal.transpose();
  for (const auto& ring : obstacles.rings) {
    text << (ring.hole ? "\nhole" : "\nboundary");
    for (const Eigen::Vector2d& p : obstacles.view(ring)) text << " (" << p.transpose() << ")";
  }
  return text.str();
}

class ShortestPaths : public testing::TestWithParam<Raster>
{
};

TEST_P(ShortestPaths, AreThoseOfTheWholeVisibilityGraph)
{
  std::mt19937 random(11);
  int ways = 0;
  int none = 0;
  for (int set = 0; set < 200; ++set) {
    const geometry::PolygonSet obstacles =
        reference::randomObstacles(random, 2 + set % 16, kSize, GetParam());
    planning::FreeSpace space;
    const auto refused = space.build(obstacles);
    ASSERT_FALSE(refused) << "set " << set << ": " << refused->text;
    planning::PathSearch search;
    search.setSpace(space);
    const reference::VisibilityGraph graph(obstacles);
    reference::MinimalConstruct plain(obstacles);
    for (int i = 0; i < 25; ++i) {
      const auto end = [&] {
        // A corner at times.
        if (!obstacles.vertices.empty() && random() % 8 == 0)
          return obstacles.vertices[random() % obstacles.vertices.size()];
        return reference::randomPoint(random, -2.0, kSize + 2.0, GetParam());
      };
      const Query query{end(), end()};
      const std::string fault = faultOf(obstacles, graph, space, search, query);
      ASSERT_EQ(fault, "") << "set " << set << ": " << shrunk(obstacles, query);
      const std::optional<double> shortest = graph.shortest(query.start, query.goal);
      ++(shortest ? ways : none);
      if (!space.locate(query.start) || !space.locate(query.goal)) continue;
      const std::optional<double> plain_length = plain.plan(query.start, query.goal);
      ASSERT_EQ(plain_length.has_value(), shortest.has_value()) << "set " << set;
      if (shortest) {
        ASSERT_NEAR(*plain_length, *shortest, 1e-12 * (1.0 + *shortest)) << "set " << set;
      }
    }
  }
  EXPECT_GT(ways, 2000);
  EXPECT_GT(none, 100);
}

INSTANTIATE_TEST_SUITE_P(Rasters, ShortestPaths, testing::Values(Raster::kCoarse, Raster::kFloat));

}  // namespace
}  // namespace polygonal_perception::test

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>

#include "polygonal_perception/planning/arc_contact.hpp"
#include "polygonal_perception/planning/contact_search.hpp"
#include "reference/arc_march.hpp"
#include "reference/random_obstacles.hpp"

namespace polygonal_perception::test {
namespace {

using planning::Arc;
using planning::ContactSearch;
using reference::MovingObstacles;

constexpr double kSize = 6.0;     // [m]
constexpr double kHorizon = 2.0;  // [s]
constexpr double kMarch = 1e-5;   // [s]
constexpr double kClose = 1e-6;   // [s]
constexpr double kFastest = 2.0;  // [m/s]
constexpr int kArcsOfAScene = 40;

class RandomDrive
{
public:
  explicit RandomDrive(std::uint32_t seed) : random_(seed) {}

  double number(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  bool chance(double share) { return number(0.0, 1.0) < share; }

  MovingObstacles obstacles(bool moves, bool grows)
  {
    const auto raster = chance(0.5) ? reference::Raster::kCoarse : reference::Raster::kFloat;
    MovingObstacles obstacles;
    obstacles.polygons = reference::randomObstacles(random_, 8, kSize, raster);
    if (moves) obstacles.velocity = {number(-1.5, 1.5), number(-1.5, 1.5)};
    if (grows) obstacles.growth = number(0.0, 0.3);
    return obstacles;
  }
  Eigen::Vector2d place() { return reference::randomPoint(random_, 0.0, kSize, reference::Raster::kFloat); }
  Arc arc(const Eigen::Vector2d& place)
  {
    planning::Twist twist;
    if (!chance(0.1)) twist.x = number(-0.5, kFastest);
    if (chance(0.3)) twist.y = number(-0.5, 0.5);
    if (!chance(0.2)) twist.theta = number(-3.0, 3.0) * (chance(0.2) ? 1e-6 : 1.0);
    return {{place, number(-M_PI, M_PI)}, twist, chance(0.3) ? number(0.0, 0.5) : 0.0};
  }

private:
  std::mt19937 random_;
};

std::string describe(const Arc& arc)
{
  std::ostringstream text;
  text.precision(17);
  text << "from " << arc.start().position.transpose() << " in the direction " << arc.direction().transpose()
       << " at " << arc.speed() << " m/s, turning by " << arc.turnRate() << " rad/s, beginning at "
       << arc.begin() << " s";
  return text.str();
}

/// Holds the search against the march, for `scenes` random scenes.
void checkScenes(bool moves, bool grows, int scenes)
{
  std::vector<planning::MovingEdge> edges;
  ContactSearch search;
  int contacts = 0;
  for (int seed = 1; seed <= scenes; ++seed) {
    RandomDrive drive(static_cast<std::uint32_t>(seed));
    const MovingObstacles obstacles = drive.obstacles(moves, grows);
    const Eigen::Vector2d place = drive.place();
    if (reference::depthIn(obstacles, place, 0.0) > 0.0) continue;
    edges.clear();
    planning::appendMovingEdges(obstacles.polygons, obstacles.velocity, obstacles.growth, edges);
    search.setEdges(edges, place, 2.1 * kFastest * kHorizon, kHorizon);
    for (int k = 0; k < kArcsOfAScene; ++k) {
      const Arc arc = drive.arc(place);
      if (reference::depthIn(obstacles, place, arc.begin()) > 0.0) continue;
      const auto found = search.firstContact(arc, kHorizon);
      const auto wanted = reference::marchToContact(arc, obstacles, kHorizon, kMarch);
      const std::string what =
          "seed " + std::to_string(seed) + ", arc " + std::to_string(k) + ", " + describe(arc);
      contacts += wanted ? 1 : 0;
      if (wanted) {
        ASSERT_TRUE(found && *found <= *wanted + kClose) << what << " enters at " << *wanted << " s, found "
                                                         << (found ? std::to_string(*found) : "nothing");
      }
      if (!found || (wanted && *found >= *wanted - 1.1 * kMarch)) continue;
      // It may have been inside for less than a step; or where corners that grow are not round.
      const double depth = reference::depthIn(obstacles, arc.position(*found), *found);
      EXPECT_GE(depth, -1e-6 - 0.42 * obstacles.growth * *found)
          << what << " is outside at " << *found << " s, where a contact was found";
    }
  }
  EXPECT_GT(contacts, scenes) << "of the marches";
}

TEST(ContactSearch, StandingObstacles)
{
  checkScenes(false, false, 1000);
}

TEST(ContactSearch, MovingObstacles)
{
  checkScenes(true, false, 1000);
}

TEST(ContactSearch, MovingObstaclesThatGrow)
{
  checkScenes(true, true, 1000);
}

/// Along a wall that it touches, a robot may drive; but not into it, by however little.
TEST(ContactSearch, AtABorder)
{
  geometry::PolygonSet box;
  box.append(std::vector<Eigen::Vector2d>{{1.0, -1.0}, {2.0, -1.0}, {2.0, 1.0}, {1.0, 1.0}}, false);
  std::vector<planning::MovingEdge> edges;
  planning::appendMovingEdges(box, Eigen::Vector2d::Zero(), 0.0, edges);
  for (const double depth : {0.0, 1e-12, 1e-6, 0.9e-3}) {
    const Eigen::Vector2d place(1.0 + depth, 0.0);
    ContactSearch search;
    search.setEdges(edges, place, 4.0, kHorizon);
    EXPECT_FALSE(search.firstContact(Arc({place, M_PI / 2.0}, {0.5, 0.0, 0.0}), kHorizon))
        << "along, " << depth;
    EXPECT_FALSE(search.firstContact(Arc({place, M_PI}, {0.5, 0.0, 0.0}), kHorizon)) << "away, " << depth;
    EXPECT_NEAR(search.firstContact(Arc({place, 0.1}, {0.5, 0.0, 0.0}), kHorizon).value_or(-1.0), 0.0, 1e-7)
        << depth;
    EXPECT_NEAR(search.firstContact(Arc({place, M_PI / 2.0}, {0.5, 0.0, -0.5}), kHorizon).value_or(-1.0), 0.0,
                1e-4)
        << "bending into it, " << depth;
  }
}

}  // namespace
}  // namespace polygonal_perception::test

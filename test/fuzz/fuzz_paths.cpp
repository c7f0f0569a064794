// Polygons of any vertices, and places among them: they are refused with a reason, or each plan is what it promises.
#include "byte_reader.hpp"
#include "polygonal_perception/planning/path_planner.hpp"
#include "reference/plan_checker.hpp"
#include "result_check.hpp"

namespace polygonal_perception::test {
namespace {

constexpr std::size_t kMostRings = 12;
constexpr std::size_t kMostVertices = 12;
constexpr int kMostPlans = 20;

/// On a raster mostly, where many points fall on the lines through others.
double coordinate(ByteReader& bytes)
{
  const std::uint8_t kind = bytes.byte();
  return kind < 200   ? 0.25 * (kind % 40)
         : kind < 250 ? bytes.raw<std::uint16_t>() / 6553.6
                      : bytes.number<double>();
}

Eigen::Vector2d place(ByteReader& bytes)
{
  const double x = coordinate(bytes);
  return {x, coordinate(bytes)};
}

std::vector<Eigen::Vector2d> ring(ByteReader& bytes, std::size_t least)
{
  std::vector<Eigen::Vector2d> ring(least + bytes.byte() % (kMostVertices - least));
  for (Eigen::Vector2d& vertex : ring) vertex = place(bytes);
  return ring;
}

}  // namespace
}  // namespace polygonal_perception::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace polygonal_perception;
  using namespace polygonal_perception::test;
  ByteReader bytes(data, size);
  const bool outside_is_free = bytes.byte() % 2 == 0;
  const std::vector<Eigen::Vector2d> extent = ring(bytes, 0);
  const double tolerance = 0.01 * bytes.byte();
  const double share = bytes.byte() / 255.0;
  planning::PathPlanner planner;
  planning::Plan plan;
  std::vector<Eigen::Vector2d> guide;
  while (!bytes.empty()) {
    geometry::PolygonSet obstacles;
    for (std::size_t i = bytes.byte() % kMostRings; i > 0; --i)
      obstacles.append(ring(bytes, 3), bytes.byte() % 4 == 0 && !obstacles.rings.empty());
    const reference::PlanChecker checker(obstacles);
    const auto refused = planner.setObstacles(obstacles, extent, outside_is_free);
    require(!refused || !refused->text.empty(), "what is refused has a reason");
    for (int i = bytes.byte() % kMostPlans; i > 0; --i) {
      const Eigen::Vector2d start = place(bytes);
      const Eigen::Vector2d goal = place(bytes);
      planner.makePlan(start, goal, tolerance, plan);
      std::string fault = checker.faultOf(plan, start, goal, tolerance);
      require(fault.empty(), fault.c_str());
      planner.keepSide(share, guide, plan);
      fault = checker.faultOf(plan, start, goal, tolerance);
      require(fault.empty(), fault.c_str());
    }
  }
  return 0;
}

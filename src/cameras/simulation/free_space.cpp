#include "cameras/simulation/free_space.hpp"

#include <algorithm>
#include <cmath>

namespace polygonal_perception::simulation {
namespace {

constexpr double kHalfPerson = 0.4;  // [m] from the middle of somebody who walks
constexpr double kStep = 0.05;       // [m] between the points of a way that are looked at

}  // namespace

FreeSpace::FreeSpace(const Scene& scene, double radius, double low, double high) : scene_(&scene)
{
  for (const Solid& solid : scene.solids) {
    if (solid.surface != Surface::kObstacle) continue;
    Outline outline = footprint(solid, low, high);
    if (outline.size() >= 3) add(std::move(outline), radius);
  }
  for (const Walker& walker : scene.walkers) add({walker.from, walker.to}, radius + kHalfPerson);
}

void FreeSpace::add(Outline outline, double distance)
{
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& vertex : outline) sum += vertex;
  const Eigen::Vector2d centre = sum / static_cast<double>(outline.size());
  double reach = 0.0;
  for (const Eigen::Vector2d& vertex : outline) reach = std::max(reach, (vertex - centre).norm());
  hindrances_.push_back({std::move(outline), distance, centre, reach + distance});
}

bool FreeSpace::contains(const Eigen::Vector2d& point) const
{
  const auto holds = [&](const Outline& outline) { return distanceTo(outline, point) == 0.0; };
  const auto hinders = [&](const Hindrance& hindrance) {
    return (hindrance.centre - point).norm() < hindrance.reach &&
           distanceTo(hindrance.outline, point) < hindrance.distance;
  };
  return std::any_of(scene_->floor.begin(), scene_->floor.end(), holds) &&
         std::none_of(hindrances_.begin(), hindrances_.end(), hinders);
}

bool FreeSpace::containsSegment(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const
{
  const int steps = static_cast<int>(std::ceil((to - from).norm() / kStep)) + 1;
  for (int i = 0; i <= steps; ++i) {
    if (!contains(from + (to - from) * (static_cast<double>(i) / steps))) return false;
  }
  return true;
}

}  // namespace polygonal_perception::simulation

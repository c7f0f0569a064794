#include "free_space.hpp"

#include <algorithm>
#include <cmath>

namespace polygonal_perception {
namespace simulation {
namespace {

constexpr double kHalfPerson = 0.4;  // [m] from the middle of somebody who walks
constexpr double kStep = 0.05;       // [m] between the points of a way that are looked at

}  // namespace

FreeSpace::FreeSpace(const Scene& scene, double radius, double low, double high)
    : scene_(&scene), radius_(radius)
{
  for (const Solid& solid : scene.solids) {
    if (solid.surface != Surface::kObstacle) continue;
    Outline outline = footprint(solid, low, high);
    if (outline.size() >= 3) occupied_.push_back(std::move(outline));
  }
  for (const Walker& walker : scene.walkers) lanes_.push_back({walker.from, walker.to});
}

bool FreeSpace::contains(const Eigen::Vector2d& point) const
{
  const auto holds = [&](const Outline& outline) { return distanceTo(outline, point) == 0.0; };
  const auto near = [&](double distance) {
    return [&point, distance](const Outline& outline) { return distanceTo(outline, point) < distance; };
  };
  return std::any_of(scene_->floor.begin(), scene_->floor.end(), holds) &&
         std::none_of(occupied_.begin(), occupied_.end(), near(radius_)) &&
         std::none_of(lanes_.begin(), lanes_.end(), near(radius_ + kHalfPerson));
}

bool FreeSpace::containsSegment(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const
{
  const int steps = static_cast<int>(std::ceil((to - from).norm() / kStep)) + 1;
  for (int i = 0; i <= steps; ++i) {
    if (!contains(from + (to - from) * (static_cast<double>(i) / steps))) return false;
  }
  return true;
}

}  // namespace simulation
}  // namespace polygonal_perception

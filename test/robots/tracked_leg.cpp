#include "tracked_leg.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace polygonal_perception::test {
namespace {

constexpr double kThickest = 0.06;           // [m] radius of a leg
constexpr double kTableTops[] = {0.6, 0.9};  // [m] heights that a leg may reach
constexpr double kNearest = 0.6;             // [m] from the camera
constexpr double kFarthest = 3.5;            // [m]
constexpr double kMargin = 0.03;             // of the image's width

Eigen::Vector2d middle(const std::vector<Eigen::Vector2d>& points)
{
  const Eigen::Vector2d sum = std::accumulate(points.begin(), points.end(), Eigen::Vector2d(0.0, 0.0));
  return sum / static_cast<double>(points.size());
}

/// Of the area, not of the vertices.
Eigen::Vector2d centroid(const Ring& ring)
{
  double area = 0.0;
  Eigen::Vector2d moment(0.0, 0.0);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d a = ring[i] - ring[0];
    const Eigen::Vector2d b = ring[(i + 1) % ring.size()] - ring[0];
    const double cross = a.x() * b.y() - a.y() * b.x();
    area += cross;
    moment += cross * (a + b) / 3.0;
  }
  return ring[0] + moment / area;
}

double topOf(const simulation::Solid& solid)
{
  double top = 0.0;
  for (const Eigen::Vector3f& vertex : solid.vertices) top = std::max(top, static_cast<double>(vertex.z()));
  return top;
}

}  // namespace

bool TrackedLeg::isInView(const simulation::SimulatedFrame& frame,
                          const simulation::PinholeCamera& camera) const
{
  const Eigen::Vector3d foot =
      frame.camera_to_world.inverse() * Eigen::Vector3d(centre_.x(), centre_.y(), 0.1);
  if (foot.z() < kNearest || foot.z() > kFarthest) return false;
  const double u = camera.fx * foot.x() / foot.z() + camera.cx;
  const double v = camera.fy * foot.y() / foot.z() + camera.cy;
  const double margin = kMargin * camera.width;
  return u > margin && u < camera.width - margin && v > margin && v < camera.height - margin;
}

void TrackedLeg::add(const Ring& boundary)
{
  centroids_.push_back(centroid(boundary));
}

Spread TrackedLeg::spread() const
{
  Spread spread;
  spread.frames = centroids_.size();
  if (centroids_.empty()) return spread;
  const Eigen::Vector2d mean = middle(centroids_);
  double squares = 0.0;
  for (const Eigen::Vector2d& point : centroids_) {
    squares += (point - mean).squaredNorm();
    spread.greatest = std::max(spread.greatest, (point - mean).norm());
  }
  spread.standard_deviation = std::sqrt(squares / static_cast<double>(centroids_.size()));
  spread.bias = (mean - centre_).norm();
  return spread;
}

std::vector<TrackedLeg> findLegs(const simulation::Scene& scene, double min_height, double max_height,
                                 double clearance)
{
  const auto outlines = scene.obstacles(0.0, min_height, max_height);
  std::vector<TrackedLeg> legs;
  for (const simulation::Solid& solid : scene.solids) {
    if (solid.surface != simulation::Surface::kObstacle) continue;
    const simulation::Outline outline = simulation::footprint(solid, min_height, max_height);
    const double top = topOf(solid);
    if (outline.size() < 3 || top < kTableTops[0] || top > kTableTops[1]) continue;
    const Eigen::Vector2d centre = middle(outline);
    double radius = 0.0;
    for (const Eigen::Vector2d& vertex : outline) radius = std::max(radius, (vertex - centre).norm());
    double nearest = std::numeric_limits<double>::infinity();
    for (const simulation::Outline& other : outlines) {
      // Its own is 0 away.
      const double distance = simulation::distanceTo(other, centre);
      if (distance > 0.0) nearest = std::min(nearest, distance);
    }
    if (radius < kThickest && nearest > clearance) legs.emplace_back(centre);
  }
  return legs;
}

}  // namespace polygonal_perception::test

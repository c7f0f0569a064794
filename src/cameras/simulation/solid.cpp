#include "polygonal_perception/cameras/simulation/solid.hpp"

#include <cmath>

#include "polygonal_perception/geometry/angle.hpp"
#include "polygonal_perception/geometry/convex_hull.hpp"
#include "polygonal_perception/geometry/distance.hpp"
#include "polygonal_perception/geometry/location.hpp"

namespace polygonal_perception::simulation {
namespace {

constexpr std::uint32_t kSides = 14;
constexpr std::uint32_t kRings = 8;

}  // namespace

Solid makeBox(const Eigen::Isometry3d& pose, const Eigen::Vector3d& size)
{
  Solid box;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d half(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
    box.vertices.emplace_back((pose * half.cwiseProduct(size)).cast<float>());
  }
  box.triangles = {{{0, 2, 1}}, {{1, 2, 3}}, {{4, 5, 6}}, {{5, 7, 6}}, {{0, 1, 4}}, {{1, 5, 4}},
                   {{2, 6, 3}}, {{3, 6, 7}}, {{0, 4, 2}}, {{2, 4, 6}}, {{1, 3, 5}}, {{3, 7, 5}}};
  return box;
}

Solid makeFrustum(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius_from,
                  double radius_to)
{
  const Eigen::Vector3d axis = (to - from).normalized();
  const Eigen::Vector3d side = axis.unitOrthogonal();
  const Eigen::Vector3d other = axis.cross(side);
  Solid frustum;
  frustum.curved = true;
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const double angle = geometry::kTwoPi * i / kSides;
    const Eigen::Vector3d out = std::cos(angle) * side + std::sin(angle) * other;
    frustum.vertices.emplace_back((from + radius_from * out).cast<float>());
    frustum.vertices.emplace_back((to + radius_to * out).cast<float>());
    const std::uint32_t a = 2 * i;
    const std::uint32_t b = 2 * ((i + 1) % kSides);
    frustum.triangles.push_back({a, b, a + 1});
    frustum.triangles.push_back({b, b + 1, a + 1});
    if (i >= 2) {
      frustum.triangles.push_back({0, a, a - 2});
      frustum.triangles.push_back({1, a - 1, a + 1});
    }
  }
  return frustum;
}

Solid makeEllipsoid(const Eigen::Isometry3d& pose, const Eigen::Vector3d& radii)
{
  Solid ellipsoid;
  ellipsoid.curved = true;
  const auto add = [&](const Eigen::Vector3d& unit) {
    ellipsoid.vertices.emplace_back((pose * unit.cwiseProduct(radii)).cast<float>());
  };
  add(-Eigen::Vector3d::UnitZ());
  add(Eigen::Vector3d::UnitZ());
  for (std::uint32_t ring = 0; ring < kRings - 1; ++ring) {
    const double elevation = 0.5 * geometry::kTwoPi * ((ring + 1.0) / kRings - 0.5);
    for (std::uint32_t i = 0; i < kSides; ++i) {
      const double angle = geometry::kTwoPi * i / kSides;
      add({std::cos(elevation) * std::cos(angle), std::cos(elevation) * std::sin(angle),
           std::sin(elevation)});
    }
  }
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const std::uint32_t next = (i + 1) % kSides;
    ellipsoid.triangles.push_back({0, 2 + next, 2 + i});
    for (std::uint32_t ring = 0; ring + 2 < kRings; ++ring) {
      const std::uint32_t low = 2 + ring * kSides;
      ellipsoid.triangles.push_back({low + i, low + next, low + kSides + i});
      ellipsoid.triangles.push_back({low + next, low + kSides + next, low + kSides + i});
    }
    const std::uint32_t top = 2 + (kRings - 2) * kSides;
    ellipsoid.triangles.push_back({1, top + i, top + next});
  }
  return ellipsoid;
}

Solid makeLevelRectangle(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double z)
{
  Solid rectangle;
  const auto height = static_cast<float>(z);
  const Eigen::Vector2f a = low.cast<float>();
  const Eigen::Vector2f b = high.cast<float>();
  rectangle.vertices = {
      {a.x(), a.y(), height}, {b.x(), a.y(), height}, {b.x(), b.y(), height}, {a.x(), b.y(), height}};
  rectangle.triangles = {{{0, 1, 2}}, {{0, 2, 3}}};
  return rectangle;
}

Outline footprint(const Solid& solid, double min_height, double max_height)
{
  std::vector<Eigen::Vector2d> points;
  for (const Eigen::Vector3f& p : solid.vertices) {
    if (p.z() >= min_height && p.z() <= max_height) points.emplace_back(p.x(), p.y());
  }
  for (const auto& triangle : solid.triangles) {
    for (int edge = 0; edge < 3; ++edge) {
      const Eigen::Vector3d a = solid.vertices[triangle[edge]].cast<double>();
      const Eigen::Vector3d b = solid.vertices[triangle[(edge + 1) % 3]].cast<double>();
      for (const double height : {min_height, max_height}) {
        if ((a.z() < height) == (b.z() < height)) continue;
        const double t = (height - a.z()) / (b.z() - a.z());
        points.emplace_back((a + t * (b - a)).head<2>());
      }
    }
  }
  return geometry::convexHull(std::move(points));
}

double distanceTo(const Outline& outline, const Eigen::Vector2d& point)
{
  const bool outside = geometry::locate(point, geometry::RingView(outline)) == geometry::Location::kOutside;
  return outside ? geometry::distanceToBoundary(point, geometry::RingView(outline)) : 0.0;
}

}  // namespace polygonal_perception::simulation

#include "rviz/message_geometry.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "polygonal_perception/geometry/polygon_set.hpp"
#include "polygonal_perception/geometry/triangulation.hpp"

namespace polygonal_perception::displays {

namespace {

bool isFinite(const geometry_msgs::Point32& p)
{
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// Of a FloorPlane or a Plane.
template <class Message>
Eigen::Vector3d normalOf(const Message& plane)
{
  return {plane.normal.x, plane.normal.y, plane.normal.z};
}

/// Whether the normal is a unit vector, and distance and points are finite.
template <class Message>
bool isPlane(const Message& plane, const std::vector<geometry_msgs::Point32>& points)
{
  constexpr double kUnitTolerance = 1e-3;
  // Written so that a normal or a distance of NaN fails.
  return std::abs(normalOf(plane).norm() - 1.0) < kUnitTolerance && std::isfinite(plane.distance) &&
         std::all_of(points.begin(), points.end(), isFinite);
}

std::vector<Eigen::Vector3d> toPoints(const std::vector<geometry_msgs::Point32>& messages)
{
  std::vector<Eigen::Vector3d> points;
  points.reserve(messages.size());
  for (const geometry_msgs::Point32& p : messages) points.emplace_back(p.x, p.y, p.z);
  return points;
}

}  // namespace

bool isDrawable(const FloorPlane& floor)
{
  return isPlane(floor, floor.hull);
}

Eigen::Vector3d footOf(const FloorPlane& floor)
{
  return -floor.distance * normalOf(floor);
}

std::vector<Eigen::Vector3d> hullOf(const FloorPlane& floor)
{
  return toPoints(floor.hull);
}

std::vector<Eigen::Vector3d> patchOf(const FloorPlane& floor, double size)
{
  const Eigen::Vector3d normal = normalOf(floor);
  const Eigen::Vector3d foot = footOf(floor);
  Eigen::Vector3d middle = foot;
  const std::vector<Eigen::Vector3d> hull = hullOf(floor);
  if (!hull.empty()) {
    middle.setZero();
    for (const Eigen::Vector3d& corner : hull) middle += corner / static_cast<double>(hull.size());
    middle -= (normal.dot(middle) + floor.distance) * normal;
  }
  // The camera looks from above its foot to what it sees of the floor.
  Eigen::Vector3d forward = middle - foot;
  forward = forward.norm() > 1e-6 ? forward.normalized() : normal.unitOrthogonal();
  const Eigen::Vector3d left = normal.cross(forward);
  const double half = size / 2.0;
  return {middle + half * (forward + left), middle + half * (left - forward),
          middle - half * (forward + left), middle + half * (forward - left)};
}

bool isDrawable(const Plane& plane)
{
  return isPlane(plane, plane.boundary) && plane.boundary.size() >= 3;
}

std::vector<Eigen::Vector3d> boundaryOf(const Plane& plane)
{
  return toPoints(plane.boundary);
}

std::vector<Eigen::Vector3d> trianglesOf(const Plane& plane)
{
  const Eigen::Vector3d normal = normalOf(plane);
  const Eigen::Vector3d a = normal.unitOrthogonal();
  const Eigen::Vector3d b = normal.cross(a);
  std::vector<Eigen::Vector2d> ring;
  for (const Eigen::Vector3d& p : boundaryOf(plane)) ring.emplace_back(a.dot(p), b.dot(p));
  geometry::PolygonSet polygon;
  polygon.append({ring.data(), ring.size()}, false);
  std::vector<Eigen::Vector3d> corners;
  for (const Eigen::Vector2d& corner : geometry::triangulate(polygon))
    corners.emplace_back(corner.x() * a + corner.y() * b - plane.distance * normal);
  return corners;
}

}  // namespace polygonal_perception::displays

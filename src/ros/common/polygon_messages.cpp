#include "polygonal_perception/ros/common/polygon_messages.hpp"

#include <array>
#include <boost/make_shared.hpp>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace polygonal_perception::ros_common {

namespace {

geometry_msgs::Polygon toExtent(const Eigen::AlignedBox2d& box, const Eigen::Isometry2d& output_pose)
{
  if (box.isEmpty()) return {};
  const Eigen::Vector2d& low = box.min();
  const Eigen::Vector2d& high = box.max();
  const std::array<Eigen::Vector2d, 4> corners = {low, Eigen::Vector2d(high.x(), low.y()), high,
                                                  Eigen::Vector2d(low.x(), high.y())};
  return toPolygon({corners.data(), corners.size()}, output_pose);
}

/// Appends a ring that can be drawn.
///
/// @return what is wrong with another one, as its text goes on after "hole 1 "; empty for a good one
std::string append(const geometry_msgs::Polygon& ring, bool hole, geometry::PolygonSet& polygons)
{
  const std::size_t size = ring.points.size();
  if (size < 3) return "has " + std::to_string(size) + " vertices, fewer than 3";
  for (std::size_t k = 0; k < size; ++k) {
    const geometry_msgs::Point32& p = ring.points[k];
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) continue;
    return "has a coordinate that is not finite, in vertex " + std::to_string(k);
  }
  polygons.append(toVertices(ring), hole);
  return {};
}

/// The same for a polygon with its holes, with the ring named.
std::string append(const ObstaclePolygon& polygon, geometry::PolygonSet& polygons)
{
  std::string wrong = append(polygon.boundary, false, polygons);
  if (!wrong.empty()) return "the boundary " + wrong;
  for (std::size_t k = 0; k < polygon.holes.size(); ++k) {
    wrong = append(polygon.holes[k], true, polygons);
    if (!wrong.empty()) return "hole " + std::to_string(k) + ' ' + wrong;
  }
  return {};
}

}  // namespace

PolygonArrayPtr toPolygonArray(const PolygonContext& context, const geometry::PolygonSet& polygons,
                               const Eigen::Isometry2d& output_pose)
{
  auto message = boost::make_shared<PolygonArray>();
  message->header = context.header;
  message->floor_status = context.floor_status;
  message->inflation_radius = context.inflation_radius;
  if (context.floor_status == FloorPlane::NOT_FOUND) return message;

  message->extent = toExtent(context.extent, output_pose);
  for (const geometry::PolygonSet::Ring& ring : polygons.rings) {
    geometry_msgs::Polygon& points =
        ring.hole ? message->polygons.back().holes.emplace_back() : message->polygons.emplace_back().boundary;
    points = toPolygon(polygons.view(ring), output_pose);
  }
  return message;
}

geometry_msgs::Polygon toPolygon(const geometry::RingView& ring, const Eigen::Isometry2d& pose)
{
  geometry_msgs::Polygon polygon;
  polygon.points.resize(ring.size());
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Eigen::Vector2f vertex = (pose * ring[k]).cast<float>();
    polygon.points[k].x = vertex.x();
    polygon.points[k].y = vertex.y();
  }
  return polygon;
}

std::vector<Eigen::Vector2d> toVertices(const geometry_msgs::Polygon& polygon)
{
  std::vector<Eigen::Vector2d> vertices;
  vertices.reserve(polygon.points.size());
  for (const geometry_msgs::Point32& p : polygon.points) vertices.emplace_back(p.x, p.y);
  return vertices;
}

Expected<geometry::PolygonSet> toPolygonSet(const ObstaclePolygon& polygon)
{
  geometry::PolygonSet polygons;
  const std::string wrong = append(polygon, polygons);
  if (!wrong.empty()) return Expected<geometry::PolygonSet>::failure(wrong);
  return polygons;
}

Expected<geometry::PolygonSet> toPolygonSet(const PolygonArray& array)
{
  geometry::PolygonSet polygons;
  for (std::size_t k = 0; k < array.polygons.size(); ++k) {
    const std::string wrong = append(array.polygons[k], polygons);
    if (wrong.empty()) continue;
    return Expected<geometry::PolygonSet>::failure("polygon " + std::to_string(k) + ": " + wrong);
  }
  return polygons;
}

}  // namespace polygonal_perception::ros_common

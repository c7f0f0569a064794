#include "ros/perception/markers.hpp"

#include <string>

#include "polygonal_perception/geometry/triangulation.hpp"

namespace polygonal_perception::ros_perception {

namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr double kLineWidth = 0.02;    // [m]
constexpr double kNormalLength = 0.5;  // [m]
// Above the floor, so that floor, fill and outline do not flicker through one another.
constexpr double kFillHeight = 0.004;  // [m]
constexpr double kLineHeight = 0.008;  // [m]

std_msgs::ColorRGBA color(float red, float green, float blue, float alpha)
{
  std_msgs::ColorRGBA color;
  color.r = red;
  color.g = green;
  color.b = blue;
  color.a = alpha;
  return color;
}

Marker& append(MarkerArray& markers, const std_msgs::Header& header, const std::string& name, int type)
{
  Marker& marker = markers.markers.emplace_back();
  marker.header = header;
  marker.ns = name;
  marker.type = type;
  marker.action = Marker::ADD;
  marker.pose.orientation.w = 1.0;
  return marker;
}

geometry_msgs::Point point(double x, double y, double z)
{
  geometry_msgs::Point point;
  point.x = x;
  point.y = y;
  point.z = z;
  return point;
}

geometry_msgs::Point point(const Eigen::Vector3d& p)
{
  return point(p.x(), p.y(), p.z());
}

/// rviz complains of lists without a point; a marker that has none is taken away instead.
void deleteIfEmpty(Marker& marker)
{
  if (marker.points.empty()) marker.action = Marker::DELETE;
}

}  // namespace

void appendPolygonMarkers(const std_msgs::Header& header, const geometry::PolygonSet& polygons,
                          const Eigen::Isometry2d& output_pose, MarkerArray& markers)
{
  const auto place = [&output_pose](const Eigen::Vector2d& vertex, double height) {
    const Eigen::Vector2d p = output_pose * vertex;
    return point(p.x(), p.y(), height);
  };
  Marker& fill = append(markers, header, "polygons/fill", Marker::TRIANGLE_LIST);
  fill.scale.x = fill.scale.y = fill.scale.z = 1.0;
  fill.color = color(0.9F, 0.3F, 0.1F, 0.4F);
  for (const Eigen::Vector2d& corner : geometry::triangulate(polygons))
    fill.points.push_back(place(corner, kFillHeight));
  deleteIfEmpty(fill);

  Marker& outline = append(markers, header, "polygons/outline", Marker::LINE_LIST);
  outline.scale.x = kLineWidth;
  outline.color = color(0.9F, 0.3F, 0.1F, 1.0F);
  for (const geometry::PolygonSet::Ring& ring : polygons.rings) {
    for (const auto [from, to] : polygons.view(ring).edges()) {
      outline.points.push_back(place(from, kLineHeight));
      outline.points.push_back(place(to, kLineHeight));
    }
  }
  deleteIfEmpty(outline);
}

void appendFloorMarkers(const std_msgs::Header& header, const perception::FloorState& floor,
                        const std::vector<Eigen::Vector3f>& hull, MarkerArray& markers)
{
  const bool known = floor.status != perception::FloorStatus::kNotFound;
  // Blue as in the paper; paler where the floor is only held.
  const std_msgs::ColorRGBA blue =
      color(0.1F, 0.4F, 1.0F, floor.status == perception::FloorStatus::kFound ? 1.0F : 0.4F);

  Marker& normal = append(markers, header, "floor/normal", Marker::ARROW);
  normal.scale.x = 0.03;  // [m] shaft
  normal.scale.y = 0.06;  // [m] head
  normal.color = blue;
  if (known) {
    const geometry::Plane& plane = floor.floor.plane;
    const Eigen::Vector3d foot = -plane.distance * plane.normal;
    normal.points = {point(foot), point(foot + kNormalLength * plane.normal)};
  }
  deleteIfEmpty(normal);

  Marker& outline = append(markers, header, "floor/hull", Marker::LINE_STRIP);
  outline.scale.x = kLineWidth;
  outline.color = blue;
  if (known && !hull.empty()) {
    for (const Eigen::Vector3f& corner : hull) outline.points.push_back(point(corner.cast<double>()));
    outline.points.push_back(outline.points.front());
  }
  deleteIfEmpty(outline);
}

}  // namespace polygonal_perception::ros_perception

#include "polygonal_perception/ros/common/polygon_markers.hpp"

#include "polygonal_perception/geometry/triangulation.hpp"
#include "polygonal_perception/ros/common/marker_parts.hpp"

namespace polygonal_perception::ros_common {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

namespace {

constexpr double kLineWidth = 0.02;  // [m]
// Above the floor, so that floor, fill and outline do not flicker through one another.
constexpr double kFillHeight = 0.004;  // [m]
constexpr double kLineHeight = 0.008;  // [m]

}  // namespace

void appendPolygonMarkers(const std_msgs::Header& header, const geometry::PolygonSet& polygons,
                          const Eigen::Isometry2d& output_pose, const PolygonColor& in, MarkerArray& markers)
{
  const auto place = [&output_pose](const Eigen::Vector2d& vertex, double height) {
    const Eigen::Vector2d p = output_pose * vertex;
    return point(p.x(), p.y(), height);
  };
  Marker& fill = append(markers, header, "polygons/fill", Marker::TRIANGLE_LIST);
  fill.scale.x = fill.scale.y = fill.scale.z = 1.0;
  fill.color = color(in.red, in.green, in.blue, 0.4F);
  for (const Eigen::Vector2d& corner : geometry::triangulate(polygons))
    fill.points.push_back(place(corner, kFillHeight));
  deleteIfEmpty(fill);

  Marker& outline = append(markers, header, "polygons/outline", Marker::LINE_LIST);
  outline.scale.x = kLineWidth;
  outline.color = color(in.red, in.green, in.blue, 1.0F);
  for (const geometry::PolygonSet::Ring& ring : polygons.rings) {
    for (const auto [from, to] : polygons.view(ring).edges()) {
      outline.points.push_back(place(from, kLineHeight));
      outline.points.push_back(place(to, kLineHeight));
    }
  }
  deleteIfEmpty(outline);
}

}  // namespace polygonal_perception::ros_common

#include "ros/perception/markers.hpp"

#include <string>

#include "polygonal_perception/ros/common/marker_parts.hpp"

namespace polygonal_perception::ros_perception {

namespace {

using ros_common::append;
using ros_common::color;
using ros_common::deleteIfEmpty;
using ros_common::point;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr double kLineWidth = 0.02;    // [m]
constexpr double kNormalLength = 0.5;  // [m]

}  // namespace

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

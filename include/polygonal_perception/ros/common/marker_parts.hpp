#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Core>
#include <string>

/// What markers are put together from.
namespace polygonal_perception::ros_common {

inline std_msgs::ColorRGBA color(float red, float green, float blue, float alpha)
{
  std_msgs::ColorRGBA color;
  color.r = red;
  color.g = green;
  color.b = blue;
  color.a = alpha;
  return color;
}

inline visualization_msgs::Marker& append(visualization_msgs::MarkerArray& markers,
                                          const std_msgs::Header& header, const std::string& name, int type)
{
  visualization_msgs::Marker& marker = markers.markers.emplace_back();
  marker.header = header;
  marker.ns = name;
  marker.type = type;
  marker.action = visualization_msgs::Marker::ADD;
  marker.pose.orientation.w = 1.0;
  return marker;
}

inline geometry_msgs::Point point(double x, double y, double z)
{
  geometry_msgs::Point point;
  point.x = x;
  point.y = y;
  point.z = z;
  return point;
}

inline geometry_msgs::Point point(const Eigen::Vector3d& p)
{
  return point(p.x(), p.y(), p.z());
}

/// rviz complains of lists without a point; a marker that has none is taken away instead.
inline void deleteIfEmpty(visualization_msgs::Marker& marker)
{
  if (marker.points.empty()) marker.action = visualization_msgs::Marker::DELETE;
}

}  // namespace polygonal_perception::ros_common

// Says for every frame whether the robot's centre may be 1.5 m ahead of the camera.
#include <polygonal_perception/PolygonArray.h>
#include <ros/ros.h>

#include <polygonal_perception/geometry/location.hpp>
#include <polygonal_perception/ros/common/polygon_messages.hpp>

using namespace polygonal_perception;

const char* stateOf(const PolygonArray& array, const Eigen::Vector2d& point)
{
  // Outside of the extent nothing is known; without a floor it is empty.
  const auto extent = ros_common::toVertices(array.extent);
  if (geometry::locate(point, geometry::RingView(extent)) == geometry::Location::kOutside) return "unknown";
  const auto polygons = ros_common::toPolygonSet(array);
  if (!polygons) return "unknown";
  return geometry::locate(point, *polygons) == geometry::Location::kInside ? "blocked" : "free";
}

void onPolygons(const PolygonArray& array)
{
  ROS_INFO("1.5 m ahead: %s", stateOf(array, {1.5, 0.0}));
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "is_free");
  ros::NodeHandle node;
  const ros::Subscriber reader = node.subscribe("polygonal_perception/polygons", 1, onPolygons);
  ros::spin();
}

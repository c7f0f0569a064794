// Says for every frame whether the robot's centre may be 1.5 m ahead of the camera.
#include <polygonal_perception/FloorPlane.h>
#include <polygonal_perception/PolygonArray.h>
#include <ros/ros.h>

using namespace polygonal_perception;

// Whether a ray from (x, y) along +x crosses a ring an odd number of times.
bool crossesOdd(const geometry_msgs::Polygon& ring, double x, double y)
{
  bool odd = false;
  for (std::size_t i = 0, j = ring.points.size() - 1; i < ring.points.size(); j = i++) {
    const auto &a = ring.points[i], &b = ring.points[j];
    if ((a.y > y) != (b.y > y) && x < a.x + (y - a.y) * (b.x - a.x) / (b.y - a.y)) odd = !odd;
  }
  return odd;
}

// Polygons do not overlap and holes lie inside of them: outside means an even number of crossings with all
// rings.
bool isFree(const PolygonArray& array, double x, double y)
{
  bool inside = false;
  for (const ObstaclePolygon& polygon : array.polygons) {
    inside ^= crossesOdd(polygon.boundary, x, y);
    for (const geometry_msgs::Polygon& hole : polygon.holes) inside ^= crossesOdd(hole, x, y);
  }
  return !inside;
}

void onPolygons(const PolygonArray& array)
{
  // Without a floor there are no polygons: that is not free space.
  const bool known = array.floor_status != FloorPlane::NOT_FOUND;
  ROS_INFO("1.5 m ahead: %s", !known ? "unknown" : isFree(array, 1.5, 0.0) ? "free" : "blocked");
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "is_free");
  ros::NodeHandle node;
  const ros::Subscriber reader = node.subscribe("polygonal_perception/polygons", 1, onPolygons);
  ros::spin();
}

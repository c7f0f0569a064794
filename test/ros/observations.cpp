#include "observations.hpp"

#include <polygonal_perception/FloorPlane.h>

#include <boost/make_shared.hpp>

namespace polygonal_perception::test {

ObservedCellsPtr observedCells(const ros::Time& stamp, const std::string& frame)
{
  constexpr std::uint32_t kSide = 40;
  auto cells = boost::make_shared<ObservedCells>();
  cells->header.stamp = stamp;
  cells->header.frame_id = frame;
  cells->floor_status = FloorPlane::FOUND;
  cells->info.resolution = 0.05F;
  cells->info.width = cells->info.height = kSide;
  cells->info.origin.position.y = -1.0;
  cells->info.origin.orientation.w = 1.0;
  cells->slab_height = 0.07F;
  cells->hit.assign(kSide * kSide, 0);
  cells->free.assign(kSide * kSide, 0xFF);
  cells->floor.assign(kSide * kSide, 1);
  cells->hit[kSide * kSide / 2 + kSide / 2] = 1;
  return cells;
}

PolygonArrayPtr boxAhead(const ros::Time& stamp, const std::string& frame)
{
  const auto box = [](float left, float bottom, float right, float top) {
    geometry_msgs::Polygon polygon;
    polygon.points.resize(4);
    polygon.points[0].x = polygon.points[3].x = left;
    polygon.points[1].x = polygon.points[2].x = right;
    polygon.points[0].y = polygon.points[1].y = bottom;
    polygon.points[2].y = polygon.points[3].y = top;
    return polygon;
  };
  auto polygons = boost::make_shared<PolygonArray>();
  polygons->header.stamp = stamp;
  polygons->header.frame_id = frame;
  polygons->floor_status = FloorPlane::FOUND;
  polygons->extent = box(-5.0F, -5.0F, 5.0F, 5.0F);
  polygons->polygons.resize(1);
  polygons->polygons[0].boundary = box(1.0F, -1.0F, 2.0F, 1.0F);
  return polygons;
}

tf2_msgs::TFMessage inOdom(const std::string& frame, const ros::Time& stamp)
{
  tf2_msgs::TFMessage message;
  message.transforms.resize(1);
  geometry_msgs::TransformStamped& transform = message.transforms[0];
  transform.header.stamp = stamp;
  transform.header.frame_id = "odom";
  transform.child_frame_id = frame;
  transform.transform.rotation.w = 1.0;
  return message;
}

}  // namespace polygonal_perception::test

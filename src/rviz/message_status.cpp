#include "rviz/message_status.hpp"

#include <algorithm>

#include "rviz/message_geometry.hpp"

namespace polygonal_perception::displays {

namespace {

using rviz::StatusProperty;

StatusLine unknownStatus(unsigned int status)
{
  return {StatusProperty::Error, QString("%1 is no status of a floor").arg(status)};
}

/// "1 polygon", "2 polygons"
QString counted(std::size_t count, const QString& noun)
{
  return QString("%1 %2%3").arg(count).arg(noun).arg(count == 1 ? "" : "s");
}

}  // namespace

StatusLine floorStatus(const PolygonArray& array)
{
  switch (array.floor_status) {
    case FloorPlane::FOUND:
      return {StatusProperty::Ok, "FOUND"};
    case FloorPlane::HELD:
      return {StatusProperty::Warn, "HELD: not found in this frame, an earlier floor still stands"};
    case FloorPlane::ASSUMED:
      return {StatusProperty::Warn, "ASSUMED: not in view, it is where the camera's mount says"};
    case FloorPlane::NOT_FOUND:
      return {StatusProperty::Warn, "NOT_FOUND: nothing is known of the obstacles"};
    default:
      return unknownStatus(array.floor_status);
  }
}

StatusLine floorStatus(const FloorPlane& floor)
{
  if (floor.status == FloorPlane::NOT_FOUND) return {StatusProperty::Warn, "NOT_FOUND"};
  if (floor.status > FloorPlane::ASSUMED) return unknownStatus(floor.status);
  if (!isDrawable(floor)) {
    return {StatusProperty::Error, "The normal is not a unit vector, or a value is not finite"};
  }
  const QString height = QString("height %1 m").arg(floor.distance, 0, 'f', 3);
  if (floor.status == FloorPlane::HELD) {
    return {StatusProperty::Warn, QString("HELD for %1 s, %2").arg(floor.age, 0, 'f', 2).arg(height)};
  }
  if (floor.status == FloorPlane::ASSUMED) return {StatusProperty::Warn, "ASSUMED, " + height};
  return {StatusProperty::Ok, QString("FOUND, %1, %2, rms error %3 mm")
                                  .arg(height, counted(floor.sample_count, "sample"))
                                  .arg(1000.0 * floor.rms_error, 0, 'f', 1)};
}

StatusLine planeStatus(const PlaneArray& array, std::size_t malformed)
{
  if (malformed > 0) {
    return {StatusProperty::Error,
            QString("%1 left out: the normal is no unit vector, or a value is not finite, or an "
                    "outline has fewer than 3 points")
                .arg(counted(malformed, "plane"))};
  }
  const auto of_kind = [&array](std::uint8_t kind) {
    return std::count_if(array.planes.begin(), array.planes.end(),
                         [kind](const Plane& plane) { return plane.kind == kind; });
  };
  return {StatusProperty::Ok, QString("%1: %2 floor, %3 horizontal, %4 vertical, %5 sloped")
                                  .arg(counted(array.planes.size(), "plane"))
                                  .arg(of_kind(Plane::FLOOR))
                                  .arg(of_kind(Plane::HORIZONTAL))
                                  .arg(of_kind(Plane::VERTICAL))
                                  .arg(of_kind(Plane::SLOPED))};
}

StatusLine polygonStatus(const PolygonArray& array, std::size_t malformed, const std::string& error)
{
  if (malformed > 0) {
    return {StatusProperty::Error,
            QString("%1 left out: %2").arg(counted(malformed, "polygon"), QString::fromStdString(error))};
  }
  std::size_t holes = 0;
  std::size_t vertices = 0;
  for (const ObstaclePolygon& polygon : array.polygons) {
    holes += polygon.holes.size();
    vertices += polygon.boundary.points.size();
    for (const geometry_msgs::Polygon& hole : polygon.holes) vertices += hole.points.size();
  }
  return {StatusProperty::Ok, QString("%1, %2, %3")
                                  .arg(counted(array.polygons.size(), "polygon"), counted(holes, "hole"),
                                       vertices == 1 ? "1 vertex" : QString("%1 vertices").arg(vertices))};
}

}  // namespace polygonal_perception::displays

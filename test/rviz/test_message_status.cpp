#include <gtest/gtest.h>

#include <limits>

#include "rviz/message_status.hpp"

namespace polygonal_perception::displays {
namespace {

using rviz::StatusProperty;

PolygonArray arrayWith(std::uint8_t status)
{
  PolygonArray array;
  array.floor_status = status;
  return array;
}

FloorPlane floorWith(std::uint8_t status)
{
  FloorPlane floor;
  floor.status = status;
  floor.normal.z = 1.0;
  floor.distance = 0.8345;
  floor.age = 0.25;
  floor.sample_count = 412;
  floor.rms_error = 0.0021;
  return floor;
}

void expectStatus(const StatusLine& status, StatusProperty::Level level, const std::string& text)
{
  EXPECT_EQ(status.level, level) << status.text.toStdString();
  EXPECT_NE(status.text.toStdString().find(text), std::string::npos)
      << "'" << status.text.toStdString() << "' does not say '" << text << "'";
}

TEST(MessageStatus, PlanesAreCountedByKind)
{
  PlaneArray array;
  for (const std::uint8_t kind : {Plane::FLOOR, Plane::VERTICAL, Plane::VERTICAL, Plane::SLOPED})
    array.planes.emplace_back().kind = kind;
  expectStatus(planeStatus(array, 0), StatusProperty::Ok,
               "4 planes: 1 floor, 0 horizontal, 2 vertical, 1 sloped");
  expectStatus(planeStatus(array, 1), StatusProperty::Error, "1 plane left out");
}

TEST(MessageStatus, OnlyAFloorThatWasFoundIsFine)
{
  expectStatus(floorStatus(arrayWith(FloorPlane::FOUND)), StatusProperty::Ok, "FOUND");
  expectStatus(floorStatus(arrayWith(FloorPlane::HELD)), StatusProperty::Warn, "HELD");
  expectStatus(floorStatus(arrayWith(FloorPlane::ASSUMED)), StatusProperty::Warn, "ASSUMED");
  expectStatus(floorStatus(arrayWith(FloorPlane::NOT_FOUND)), StatusProperty::Warn, "NOT_FOUND");
  expectStatus(floorStatus(arrayWith(7)), StatusProperty::Error, "7");
}

TEST(MessageStatus, AFloorTellsItsMeasurements)
{
  expectStatus(floorStatus(floorWith(FloorPlane::FOUND)), StatusProperty::Ok,
               "height 0.835 m, 412 samples, rms error 2.1 mm");
  expectStatus(floorStatus(floorWith(FloorPlane::HELD)), StatusProperty::Warn,
               "HELD for 0.25 s, height 0.835 m");
  expectStatus(floorStatus(floorWith(FloorPlane::ASSUMED)), StatusProperty::Warn, "ASSUMED, height 0.835 m");
  expectStatus(floorStatus(floorWith(FloorPlane::NOT_FOUND)), StatusProperty::Warn, "NOT_FOUND");
  expectStatus(floorStatus(floorWith(7)), StatusProperty::Error, "7");
}

TEST(MessageStatus, APlaneThatCannotBeDrawnIsAnError)
{
  FloorPlane floor = floorWith(FloorPlane::FOUND);
  floor.distance = std::numeric_limits<double>::quiet_NaN();
  expectStatus(floorStatus(floor), StatusProperty::Error, "not finite");
  floor.status = FloorPlane::NOT_FOUND;
  expectStatus(floorStatus(floor), StatusProperty::Warn, "NOT_FOUND");
}

TEST(MessageStatus, PolygonsHolesAndVerticesAreCounted)
{
  PolygonArray array;
  expectStatus(polygonStatus(array, 0, ""), StatusProperty::Ok, "0 polygons, 0 holes, 0 vertices");
  array.polygons.resize(1);
  array.polygons[0].boundary.points.resize(4);
  array.polygons[0].holes.resize(2);
  array.polygons[0].holes[1].points.resize(3);
  expectStatus(polygonStatus(array, 0, ""), StatusProperty::Ok, "1 polygon, 2 holes, 7 vertices");
  expectStatus(polygonStatus(array, 1, "hole 0 is bad"), StatusProperty::Error,
               "1 polygon left out: hole 0 is bad");
}

}  // namespace
}  // namespace polygonal_perception::displays

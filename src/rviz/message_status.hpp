#pragma once

#include <polygonal_perception/FloorPlane.h>
#include <polygonal_perception/PlaneArray.h>
#include <polygonal_perception/PolygonArray.h>
#include <rviz/properties/status_property.h>

#include <QString>
#include <string>

namespace polygonal_perception::displays {

/// A line of the status that rviz shows under a display.
struct StatusLine
{
  rviz::StatusProperty::Level level;
  QString text;
};

/// What an array says of the floor that its polygons stand on. Anything but FOUND is a warning.
StatusLine floorStatus(const PolygonArray& array);

/// Status of the floor, its height, how well it was measured. Anything but FOUND is a warning; a plane that
/// cannot be drawn is an error.
StatusLine floorStatus(const FloorPlane& floor);

/// How many planes of each kind an array has.
///
/// @param malformed  number of planes that cannot be drawn; any is an error
StatusLine planeStatus(const PlaneArray& array, std::size_t malformed);

/// How many polygons, holes and vertices an array has.
///
/// @param malformed  number of polygons that cannot be drawn; any is an error
/// @param error      what is wrong with one of them
StatusLine polygonStatus(const PolygonArray& array, std::size_t malformed, const std::string& error);

}  // namespace polygonal_perception::displays

#include <gtest/gtest.h>

#include <sstream>

#include "polygonal_perception/mapping/geojson.hpp"

namespace polygonal_perception::mapping {
namespace {

MapFile mapOf(const std::string& text)
{
  auto map = readGeoJson(text);
  if (const auto* const error = std::get_if<MapFileError>(&map)) {
    ADD_FAILURE() << error->text << "\nin " << text;
    return {};
  }
  return std::get<MapFile>(std::move(map));
}

/// A collection of one geometry, and of members.
std::string collection(const std::string& geometry, const std::string& members = "")
{
  return R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": null, "geometry": )" +
         geometry + "}]" + members + "}";
}

std::string polygon(const std::string& coordinates)
{
  return collection(R"({"type": "Polygon", "coordinates": )" + coordinates + "}");
}

/// Rings as "x,y x,y" with an "o" before a hole.
std::string ringsOf(const MapFile& map)
{
  std::ostringstream text;
  for (const auto& ring : map.polygons.rings) {
    text << (ring.hole ? "o" : "[");
    for (const Eigen::Vector2d& vertex : map.polygons.view(ring))
      text << ' ' << vertex.x() << ',' << vertex.y();
    text << "] ";
  }
  return text.str();
}

TEST(GeoJsonReading, HandDrawn)
{
  const MapFile map = mapOf(polygon("[[[0, 0], [8, 0], [8, 8], [0, 0]]]"));
  EXPECT_EQ(ringsOf(map), "[ 0,0 8,0 8,8] ");
  EXPECT_EQ(map.frame_id, "");
  EXPECT_EQ(map.inflation_radius, 0.0);
  EXPECT_FALSE(map.cells);
}

TEST(GeoJsonReading, NothingDrawn)
{
  EXPECT_EQ(ringsOf(mapOf(R"({"features": [], "type": "FeatureCollection"})")), "");
  EXPECT_EQ(ringsOf(mapOf(collection(R"({"type": "MultiPolygon", "coordinates": []})"))), "");
}

TEST(GeoJsonReading, ByteOrderMark)
{
  EXPECT_EQ(ringsOf(mapOf("\xef\xbb\xbf" + polygon("[[[0, 0], [8, 0], [8, 8], [0, 0]]]"))),
            "[ 0,0 8,0 8,8] ");
}

TEST(GeoJsonReading, RingsThatRunTheWrongWayAreTurnedRound)
{
  EXPECT_EQ(ringsOf(mapOf(polygon("[[[0,0],[0,8],[8,8],[8,0],[0,0]], [[2,2],[6,2],[6,6],[2,6],[2,2]]]"))),
            "[ 0,0 8,0 8,8 0,8] o 2,2 2,6 6,6 6,2] ");
  // So narrow that its area comes out as 0.
  const MapFile sliver = mapOf(polygon("[[[12, 12], [0.5, 0.5000000000000001], [24, 24], [12, 12]]]"));
  ASSERT_EQ(sliver.polygons.vertices.size(), 3U);
  EXPECT_EQ(sliver.polygons.vertices[1], Eigen::Vector2d(24, 24));
}

TEST(GeoJsonReading, AMultiPolygonIsTakenApart)
{
  const std::string coordinates =
      "[[[[0,0],[8,0],[8,8],[0,8],[0,0]], [[2,2],[2,6],[6,6],[6,2],[2,2]]], [[[3,3],[5,3],[4,5],[3,3]]]]";
  EXPECT_EQ(ringsOf(mapOf(collection(R"({"coordinates": )" + coordinates + R"(, "type": "MultiPolygon"})"))),
            "[ 0,0 8,0 8,8 0,8] o 2,2 2,6 6,6 6,2] [ 3,3 5,3 4,5] ");
}

TEST(GeoJsonReading, ThirdCoordinatesAndForeignMembersAreLeftOut)
{
  const MapFile map = mapOf(
      R"({"bbox": [0, 0, 8, 8], "crs": {"type": "name"}, "name": "drawn", "type": "FeatureCollection", "features": [
        {"id": 7, "type": "Feature", "properties": {"fill": "#ff0000", "features": [[1]]},
         "geometry": {"bbox": [], "type": "Polygon", "coordinates": [[[0,0,1.5],[8,0,"a"],[8,8],[0,0,2]]]}}]})");
  EXPECT_EQ(ringsOf(map), "[ 0,0 8,0 8,8] ");
}

TEST(GeoJsonReading, OurMembers)
{
  const MapFile map = mapOf(
      R"({"cells": {"layers": [{"runs": [1,0, 1,5, 4,255], "name": "free"}, {"name": "\u00e9", "runs": [6, 1]}],
          "origin_x": -1, "origin_y": 2.5, "resolution": 5e-2, "cells_x": 3, "cells_y": 2, "more": {"runs": "a"}},
          "inflation_radius": 1, "frame_id": "map", "units": "metres",
          "features": [], "type": "FeatureCollection"})");
  EXPECT_EQ(map.frame_id, "map");
  EXPECT_EQ(map.inflation_radius, 1.0);
  ASSERT_TRUE(map.cells);
  EXPECT_EQ(map.cells->cells_x, 3);
  EXPECT_EQ(map.cells->cells_y, 2);
  EXPECT_EQ(map.cells->resolution, 0.05);
  EXPECT_EQ(map.cells->origin_x, -1.0);
  EXPECT_EQ(map.cells->origin_y, 2.5);
  ASSERT_EQ(map.cells->layers.size(), 2U);
  EXPECT_EQ(map.cells->layers[0].name, "free");
  EXPECT_EQ(map.cells->layers[0].values, (std::vector<std::uint8_t>{0, 5, 255, 255, 255, 255}));
  EXPECT_EQ(map.cells->layers[1].name, "\u00e9");
  EXPECT_EQ(map.cells->layers[1].values, std::vector<std::uint8_t>(6, 1));
}

TEST(GeoJsonReading, OfAMemberThatIsThereTwiceTheLastCounts)
{
  const std::string rest = R"(], "type": "FeatureCollection"})";
  const std::string cells =
      R"("cells_x": 1, "cells_y": 1, "resolution": 1, "origin_x": 0, "origin_y": 0, "layers": [)";
  const MapFile map = mapOf(
      R"({"cells": {)" + cells + R"({"name": "a", "runs": [1, 1]}, {"name": "b", "runs": [1, 2]}]}, )" +
      R"("cells": {)" + cells + R"({"name": "c", "runs": [9, 9], "runs": [1, 3]}]}, "features": [)" + rest);
  ASSERT_TRUE(map.cells);
  ASSERT_EQ(map.cells->layers.size(), 1U);
  EXPECT_EQ(map.cells->layers[0].name, "c");
  EXPECT_EQ(map.cells->layers[0].values, std::vector<std::uint8_t>{3});
}

}  // namespace
}  // namespace polygonal_perception::mapping

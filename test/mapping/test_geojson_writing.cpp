#include <gtest/gtest.h>

#include "polygonal_perception/mapping/geojson.hpp"

namespace polygonal_perception::mapping {
namespace {

using Vertices = std::vector<Eigen::Vector2d>;

std::string textOf(const MapFile& map)
{
  const auto text = writeGeoJson(map);
  const auto* const error = std::get_if<MapFileError>(&text);
  return error == nullptr ? std::get<std::string>(text) : "error: " + error->text;
}

TEST(GeoJsonWriting, AnEmptyMap)
{
  EXPECT_EQ(textOf({}), R"({"type": "FeatureCollection",
"frame_id": "",
"units": "metres",
"inflation_radius": 0.0,
"features": []}
)");
}

TEST(GeoJsonWriting, PolygonsAndCells)
{
  MapFile map;
  map.frame_id = "a \"map\"\n\u00e9";
  map.inflation_radius = 0.1 + 0.2;
  map.polygons.append(Vertices{{0, 0}, {8, 0}, {8, 8.5}}, false);
  map.polygons.append(Vertices{{4, 1}, {4, 3}, {6, 3}}, true);
  map.polygons.append(Vertices{{-3e-7, 2}, {-1, 1}, {-1, -0.0}}, false);
  map.cells =
      SavedCells{3, 2, 0.05, -1e22, 0.1f, {{"free", {7, 7, 7, 7, 7, 7}}, {"hit", {0, 255, 255, 1, 0, 0}}}};
  EXPECT_EQ(textOf(map), R"({"type": "FeatureCollection",
"frame_id": "a \"map\"\né",
"units": "metres",
"inflation_radius": 0.30000000000000004,
"features": [
{"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": [[[0.0, 0.0], [8.0, 0.0], [8.0, 8.5], [0.0, 0.0]], [[4.0, 1.0], [4.0, 3.0], [6.0, 3.0], [4.0, 1.0]]]}},
{"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": [[[-3e-07, 2.0], [-1.0, 1.0], [-1.0, -0.0], [-3e-07, 2.0]]]}}
],
"cells": {"cells_x": 3, "cells_y": 2, "resolution": 0.05, "origin_x": -1e+22, "origin_y": 0.10000000149011612, "layers": [
{"name": "free", "runs": [6,7]},
{"name": "hit", "runs": [1,0,2,255,1,1,2,0]}]}}
)");
}

TEST(GeoJsonWriting, WhatReadingWouldRefuse)
{
  MapFile map;
  map.polygons.append(Vertices{{0, 0}, {8, 8}, {8, 0}}, false);
  EXPECT_EQ(textOf(map), "error: ring 0 is a boundary and runs clockwise at (0, 0)");
}

}  // namespace
}  // namespace polygonal_perception::mapping

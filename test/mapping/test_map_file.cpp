#include <gtest/gtest.h>

#include <limits>

#include "polygonal_perception/mapping/map_file.hpp"

namespace polygonal_perception::mapping {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

using Vertices = std::vector<Eigen::Vector2d>;

MapFile goodMap()
{
  MapFile map;
  map.frame_id = "map";
  map.inflation_radius = 0.3;
  map.polygons.append(Vertices{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, false);
  map.polygons.append(Vertices{{2, 2}, {2, 6}, {6, 6}, {6, 2}}, true);
  map.cells =
      SavedCells{2, 3, 0.05, -1.0, 2.0, {{"free", {1, 2, 3, 4, 5, 6}}, {"hit", {0, 0, 0, 0, 0, 255}}}};
  return map;
}

/// The text of the fault that a map has after a change.
template <class Change>
std::string faultAfter(Change&& change)
{
  MapFile map = goodMap();
  change(map);
  const auto fault = findFault(map);
  return fault ? fault->text : "none";
}

TEST(MapFile, GoodOnes)
{
  EXPECT_FALSE(findFault({}));
  EXPECT_EQ(faultAfter([](MapFile&) {}), "none");
  EXPECT_EQ(faultAfter([](MapFile& map) { map.cells->layers.clear(); }), "none");
  EXPECT_EQ(faultAfter([](MapFile& map) { map.frame_id = "caf\u00e9 \"\\\n"; }), "none");
  EXPECT_EQ(faultAfter([](MapFile& map) {
              map.polygons.vertices[2] = {1e100, 1e100};
              map.polygons.vertices[0] = {-1e-100, -1e-100};
            }),
            "none");
}

TEST(MapFile, BadTexts)
{
  EXPECT_EQ(faultAfter([](MapFile& map) { map.frame_id = "\xff"; }), "the frame_id is no UTF-8");
  EXPECT_EQ(faultAfter([](MapFile& map) { map.cells->layers[1].name = "\xc3"; }),
            "cells, layer 1: the name is no UTF-8");
  EXPECT_EQ(faultAfter([](MapFile& map) { map.cells->layers[1].name = "free"; }),
            "cells, layer 1: there are two of the name \"free\"");
}

TEST(MapFile, BadRadii)
{
  const auto fault_with = [](double radius) {
    return faultAfter([radius](MapFile& map) { map.inflation_radius = radius; });
  };
  EXPECT_EQ(fault_with(0.0), "none");
  EXPECT_EQ(fault_with(-0.1), "inflation_radius is -0.1, accepted is a finite number from 0 [m]");
  EXPECT_EQ(fault_with(kNan), "inflation_radius is NaN, accepted is a finite number from 0 [m]");
  EXPECT_EQ(fault_with(kInfinite), "inflation_radius is infinite, accepted is a finite number from 0 [m]");
}

TEST(MapFile, BadPolygons)
{
  const auto fault_with = [](double x) {
    return faultAfter([x](MapFile& map) { map.polygons.vertices[5].x() = x; });
  };
  EXPECT_EQ(fault_with(12.0), "ring 1 crosses or touches itself at (6, 3.6)");
  const std::string accepted = ", accepted are coordinates of 1e-100 to 1e100 m either way, and 0";
  EXPECT_EQ(fault_with(kNan), "ring 1 has a vertex at (NaN, 6.0)" + accepted);
  EXPECT_EQ(fault_with(-kInfinite), "ring 1 has a vertex at (-infinite, 6.0)" + accepted);
  EXPECT_EQ(fault_with(1.1e100), "ring 1 has a vertex at (1.1e+100, 6.0)" + accepted);
  EXPECT_EQ(fault_with(-1e-101), "ring 1 has a vertex at (-1e-101, 6.0)" + accepted);
  EXPECT_EQ(faultAfter([](MapFile& map) { map.polygons.rings[0].hole = true; }),
            "ring 0 is a hole and runs counter-clockwise at (0, 0)");
  EXPECT_EQ(faultAfter([](MapFile& map) { map.polygons.vertices.resize(kMostSavedVertices + 1); }),
            "there are 1000001 vertices, accepted are at most 1000000");
}

TEST(MapFile, BadCells)
{
  EXPECT_EQ(faultAfter([](MapFile& map) { map.cells->cells_x = 0; }),
            "cells: there are 0 x 3, accepted is at least 1 x 1");
  EXPECT_EQ(faultAfter([](MapFile& map) { map.cells->cells_y = -3; }),
            "cells: there are 2 x -3, accepted is at least 1 x 1");
  EXPECT_EQ(faultAfter([](MapFile& map) { map.cells->cells_x = map.cells->cells_y = 0x7fffffff; }),
            "cells: there are 2147483647 x 2147483647, accepted are at most 100000000");
  EXPECT_EQ(faultAfter([](MapFile& map) { map.cells->resolution = 0.0; }),
            "cells: resolution is 0.0, accepted is a finite number above 0 [m]");
  EXPECT_EQ(faultAfter([](MapFile& map) { map.cells->resolution = kNan; }),
            "cells: resolution is NaN, accepted is a finite number above 0 [m]");
  EXPECT_EQ(faultAfter([](MapFile& map) { map.cells->origin_y = kInfinite; }),
            "cells: the origin is (-1.0, infinite), accepted are finite numbers [m]");
  EXPECT_EQ(faultAfter([](MapFile& map) { map.cells->layers[1].values.pop_back(); }),
            "cells, layer 1: there are 5 values, accepted are 2 x 3");
  EXPECT_EQ(faultAfter([](MapFile& map) { map.cells->layers.resize(kMostSavedLayers + 1); }),
            "cells: there are more than 1000 layers");
}

TEST(MapFile, TooManyCellsInAllLayers)
{
  MapFile map;
  map.cells = SavedCells{10000, 5000, 0.05, 0.0, 0.0, {{"a", {}}, {"b", {}}}};
  for (CellLayer& layer : map.cells->layers) layer.values.resize(50'000'000);
  EXPECT_FALSE(findFault(map));
  map.cells->layers.push_back({"c", map.cells->layers[0].values});
  ASSERT_TRUE(findFault(map));
  EXPECT_EQ(findFault(map)->text, "cells: all layers together have more than 100000000 values");
}

}  // namespace
}  // namespace polygonal_perception::mapping

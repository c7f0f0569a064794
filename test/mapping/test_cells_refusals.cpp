#include <gtest/gtest.h>

#include "mapping/geojson_reader.hpp"
#include "polygonal_perception/mapping/geojson.hpp"

namespace polygonal_perception::mapping {
namespace {

std::string errorOf(const std::variant<MapFile, MapFileError>& result)
{
  const auto* const error = std::get_if<MapFileError>(&result);
  return error == nullptr ? "none" : error->text;
}

std::string textOf(const std::string& cells)
{
  return R"({"type": "FeatureCollection", "features": [], "cells": )" + cells + "}";
}

std::string errorOf(const std::string& cells)
{
  return errorOf(readGeoJson(textOf(cells)));
}

std::string grid(const std::string& cells_x, const std::string& cells_y, const std::string& layers)
{
  return R"({"layers": )" + layers + R"(, "cells_x": )" + cells_x + R"(, "cells_y": )" + cells_y +
         R"(, "resolution": 0.05, "origin_x": 0, "origin_y": 0})";
}

/// A layer of 3 x 2 cells after a good one.
std::string runs(const std::string& runs)
{
  return grid("3", "2", R"([{"name": "free", "runs": [6,0]}, {"name": "hit", "runs": )" + runs + "}]");
}

TEST(CellsRefusals, NoGrid)
{
  EXPECT_EQ(errorOf("7"), "cells: cells_x is missing, accepted is a whole number from 1 to 100000000");
  for (const char* size : {"-3", "3.0", "\"3\"", "100000001", "18446744073709551615", "null"}) {
    EXPECT_EQ(errorOf(grid("3", size, "[]")),
              std::string("cells: cells_y is ") + size + ", accepted is a whole number from 1 to 100000000");
  }
  EXPECT_EQ(errorOf(grid("0", "3", "[]")), "cells: there are 0 x 3, accepted is at least 1 x 1");
  EXPECT_EQ(errorOf(grid("10000", "10001", "[]")),
            "cells: there are 10000 x 10001, accepted are at most 100000000");
  EXPECT_EQ(errorOf(grid("100000000", "100000000", "[]")),
            "cells: there are 100000000 x 100000000, accepted are at most 100000000");
  EXPECT_EQ(errorOf(grid("1", "1", "{}")), "cells: layers is an object, accepted is an array");
  EXPECT_EQ(errorOf(R"({"cells_x": 1, "cells_y": 1})"), "cells: resolution is missing, accepted is a number");
  EXPECT_EQ(
      errorOf(R"({"cells_x": 1, "cells_y": 1, "resolution": 0, "origin_x": 0, "origin_y": 0, "layers": []})"),
      "cells: resolution is 0.0, accepted is a finite number above 0 [m]");
}

TEST(CellsRefusals, NoLayers)
{
  EXPECT_EQ(errorOf(grid("3", "2", "[7]")), "cells: layer 0: name is missing, accepted is a text");
  EXPECT_EQ(errorOf(grid("3", "2", R"([{"name": 7, "runs": [6,0]}])")),
            "cells: layer 0: name is 7, accepted is a text");
  EXPECT_EQ(errorOf(grid("3", "2", R"([{"name": "a"}])")),
            "cells: layer 0: runs is missing, accepted is an array");
  EXPECT_EQ(errorOf(grid("3", "2", R"([{"name": "a", "runs": [6,0]}, {"name": "b", "runs": 0}])")),
            "cells: layer 1: runs is 0, accepted is an array");
  EXPECT_EQ(errorOf(grid("3", "2", R"([{"name": "a", "runs": [6,0]}, {"name": "a", "runs": [6,0]}])")),
            "cells, layer 1: there are two of the name \"a\"");
}

TEST(CellsRefusals, WrongSizes)
{
  EXPECT_EQ(errorOf(runs("[6,1]")), "none");
  EXPECT_EQ(errorOf(runs("[]")), "cells, layer 1: there are 0 values, accepted are 3 x 2");
  EXPECT_EQ(errorOf(runs("[2,0,3,1]")), "cells, layer 1: there are 5 values, accepted are 3 x 2");
  EXPECT_EQ(errorOf(runs("[2,0,5,1]")), "cells, layer 1: there are 7 values, accepted are 3 x 2");
}

TEST(CellsRefusals, WrongRuns)
{
  const std::string in = "cells, layer 1, runs: ";
  EXPECT_EQ(errorOf(runs("[4,0,2]")), in + "the last count has no value");
  EXPECT_EQ(errorOf(runs("[4,0,0,1,2,1]")), in + "entry 2 is 0, accepted is a count, a whole number from 1");
  EXPECT_EQ(errorOf(runs("[4,256,2,0]")),
            in + "entry 1 is 256, accepted is a value, a whole number from 0 to 255");
  for (const char* entry : {"-1", "0.5", "1e30", "\"1\"", "null", "true"}) {
    EXPECT_EQ(errorOf(runs(std::string("[4,") + entry + ",2,0]")),
              in + "entry 1 is " + (entry == std::string("1e30") ? "1e+30" : entry) +
                  ", accepted is a value, a whole number from 0 to 255");
  }
  EXPECT_EQ(errorOf(runs("[[4,0]]")), in + "entry 0 is an array, accepted is a count, a whole number from 1");
  EXPECT_EQ(errorOf(runs("[4,{")),
            in + "entry 1 is an object, accepted is a value, a whole number from 0 to 255");
}

TEST(CellsRefusals, GiantCountsTakeNoMemory)
{
  const std::string in = "cells, layer 1, runs: entry ";
  EXPECT_EQ(errorOf(runs("[18446744073709551615,0]")),
            in + "0 is a count of 18446744073709551615, and there can be no more than 99999994 values");
  EXPECT_EQ(errorOf(runs("[1,0,99999994,0]")),
            in + "2 is a count of 99999994, and there can be no more than 99999993 values");
  JsonLimits limits;
  limits.cells = 20;
  std::string layers = R"([{"name": "a", "runs": [9,0]}, {"name": "b", "runs": [9,0]}, )";
  EXPECT_EQ(errorOf(readLimited(textOf(grid("3", "3", layers + R"({"name": "c", "runs": [2,0]}])")), limits)),
            "cells, layer 2: there are 2 values, accepted are 3 x 3");
  EXPECT_EQ(errorOf(readLimited(textOf(grid("3", "3", layers + R"({"name": "c", "runs": [9,0]}])")), limits)),
            "cells, layer 2, runs: entry 0 is a count of 9, and there can be no more than 2 values");
}

TEST(CellsRefusals, TooManyLayers)
{
  std::string layers;
  for (int k = 0; k < 1000; ++k) layers += R"({"name": ")" + std::to_string(k) + R"(", "runs": [1,0]}, )";
  EXPECT_EQ(errorOf(grid("1", "1", "[" + layers + R"({"name": "a", "runs": [1,0]}])")),
            "cells: there are more than 1000 layers");
  EXPECT_EQ(errorOf(grid("1", "1", "[" + layers + "0]")), "cells: there are more than 1000 layers");
}

}  // namespace
}  // namespace polygonal_perception::mapping

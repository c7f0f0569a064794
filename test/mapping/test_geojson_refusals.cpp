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

std::string errorOf(const std::string& text)
{
  return errorOf(readGeoJson(text));
}

std::string features(const std::string& features)
{
  return R"({"type": "FeatureCollection", "features": [)" + features + "]}";
}

std::string geometry(const std::string& geometry)
{
  return features(R"({"type": "Feature", "geometry": )" + geometry + "}");
}

const std::string kGood =
    R"({"type": "Feature", "geometry": {"type": "Polygon", "coordinates": [[[20,20],[24,20],[24,24],[20,20]]]}})";

/// The second feature, after a good one.
std::string polygon(const std::string& coordinates)
{
  return features(kGood + R"(, {"type": "Feature", "geometry": {"type": "Polygon", "coordinates": )" +
                  coordinates + "}}");
}

std::string multiPolygon(const std::string& coordinates)
{
  return features(R"({"type": "Feature", "geometry": {"type": "MultiPolygon", "coordinates": )" +
                  coordinates + "}}");
}

std::string members(const std::string& members)
{
  return R"({"type": "FeatureCollection", "features": [], )" + members + "}";
}

std::string repeated(const std::string& text, int times)
{
  std::string result;
  for (int k = 0; k < times; ++k) result += text;
  return result;
}

TEST(GeoJsonRefusals, NoJson)
{
  EXPECT_EQ(errorOf(""), "the text ends too early, at line 1, column 1");
  EXPECT_EQ(errorOf("{\n\"type\": \"Feat"), "the text ends too early, at line 2, column 14");
  EXPECT_EQ(errorOf("[1,\n2\n,x"), "this is no JSON at line 3, column 2");
  EXPECT_EQ(errorOf("{} {}"), "this is no JSON at line 1, column 4");
  EXPECT_EQ(errorOf("{\"type\": \"\xff\"}"), "this is no JSON at line 1, column 11");
  EXPECT_EQ(errorOf(polygon("[[[0,0],[NaN,1]]]")),
            "feature 1, ring 0: this is no JSON at line 1, column 226");
  EXPECT_EQ(errorOf(std::string("\0\0", 2)), "this is no JSON at line 1, column 1");
}

TEST(GeoJsonRefusals, TruncatedAnywhere)
{
  const std::string text = polygon("[[[0,0],[8,0],[8,8],[0,0]], [[5,1],[5,2],[6,2],[5,1]]]");
  ASSERT_EQ(errorOf(text), "none");
  for (std::size_t size = 0; size < text.size(); ++size) {
    const std::string error = errorOf(text.substr(0, size));
    EXPECT_NE(error.find("the text ends too early"), std::string::npos) << size << ": " << error;
  }
  EXPECT_EQ(errorOf(text.substr(0, text.find("[5,1]"))),
            "feature 1, ring 1: the text ends too early, at line 1, column 246");
}

TEST(GeoJsonRefusals, DeepNesting)
{
  const std::string error = "arrays and objects are more than 32 deep in one another";
  EXPECT_EQ(errorOf(repeated("[", 33)), error);
  EXPECT_EQ(errorOf(repeated("[", 1'000'000)), error);
  EXPECT_EQ(errorOf(repeated("{\"a\":", 1'000'000)), error);
  EXPECT_EQ(errorOf(geometry(R"({"type": "Polygon", "coordinates": )" + repeated("[", 1000))),
            "feature 0, polygon 0, ring 0: " + error);
  EXPECT_EQ(errorOf(members("\"more\": " + repeated("[", 31) + repeated("]", 31))), "none");
}

TEST(GeoJsonRefusals, NoFeatureCollection)
{
  EXPECT_EQ(errorOf("7"), "type is missing, accepted is \"FeatureCollection\"");
  EXPECT_EQ(errorOf(kGood), "type is \"Feature\", accepted is \"FeatureCollection\"");
  EXPECT_EQ(errorOf(R"({"type": "FeatureCollection"})"), "features is missing, accepted is an array");
  EXPECT_EQ(errorOf(R"({"type": "FeatureCollection", "features": {}})"),
            "features is an object, accepted is an array");
  EXPECT_EQ(errorOf(features(kGood + ", 7")), "feature 1 is 7, accepted is \"Feature\"");
  EXPECT_EQ(errorOf(features("{}")), "feature 0 is an object without a type, accepted is \"Feature\"");
  EXPECT_EQ(errorOf(features(R"({"type": "Polygon", "coordinates": []})")),
            "feature 0 is \"Polygon\", accepted is \"Feature\"");
}

TEST(GeoJsonRefusals, NoPolygons)
{
  EXPECT_EQ(errorOf(features(R"({"type": "Feature"})")), "feature 0 has no geometry");
  const std::string accepted = ", accepted are \"Polygon\" and \"MultiPolygon\"";
  EXPECT_EQ(errorOf(geometry("null")), "feature 0 is null" + accepted);
  EXPECT_EQ(errorOf(geometry(R"({"type": "Point", "coordinates": [1, 2]})")),
            "feature 0 is \"Point\"" + accepted);
  EXPECT_EQ(errorOf(geometry(R"({"type": 3})")), "feature 0 is 3" + accepted);
  EXPECT_EQ(errorOf(geometry(R"({"type": ")" + repeated("\u00e9", 100) + "\"}")),
            "feature 0 is \"" + repeated("\\u00e9", 9) + "\\u00e..." + accepted);
  EXPECT_EQ(errorOf(geometry(R"({"type": "Polygon"})")), "feature 0 has no array of coordinates");
  EXPECT_EQ(errorOf(polygon("7")), "feature 1 has no array of coordinates");
  EXPECT_EQ(errorOf(polygon("[]")), "feature 1 is no array of rings");
  EXPECT_EQ(errorOf(multiPolygon("[[[[0,0],[8,0],[8,8],[0,0]]], []]")),
            "feature 0, polygon 1 is no array of rings");
  EXPECT_EQ(errorOf(multiPolygon("[7]")), "feature 0, polygon 0 is no array of rings");
}

TEST(GeoJsonRefusals, NoRings)
{
  EXPECT_EQ(errorOf(polygon("[7]")), "feature 1, ring 0 is 7, accepted is an array of positions");
  EXPECT_EQ(errorOf(polygon("[[[0,0],[8,0],[8,8],[0,0]], [[5,1],[5,2],[5,1]]]")),
            "feature 1, ring 1 has 3 positions, accepted are at least 4, the last of them the first");
  EXPECT_EQ(errorOf(polygon("[[[0,0],[8,0],[8,8],[0,0.5]]]")),
            "feature 1, ring 0 is not closed: it begins at (0.0, 0.0) and ends at (0.0, 0.5)");
  EXPECT_EQ(errorOf(multiPolygon("[[[[0,0],[8,0],[8,8],[0,0]], [[5,1],[5,2],[6,2],[5,3]]]]")),
            "feature 0, polygon 0, ring 1 is not closed: it begins at (5.0, 1.0) and ends at (5.0, 3.0)");
}

TEST(GeoJsonRefusals, NoFiniteNumbers)
{
  for (const char* position : {"7", "[]", "[8]", "[8,\"8\"]", "[null,8]", "[[8],8]", "{}"}) {
    EXPECT_EQ(errorOf(polygon(std::string("[[[0,0],[8,0],") + position + ",[0,0]]]")),
              "feature 1, ring 0, position 2 is no array of two numbers, after (8.0, 0.0)");
  }
  EXPECT_EQ(errorOf(polygon("[[7,[8,0],[8,8],[0,0]]]")),
            "feature 1, ring 0, position 0 is no array of two numbers");
  EXPECT_EQ(errorOf(polygon("[[[0,0],[1e999,8]]]")),
            "feature 1, ring 0: the number 1e999 at line 1, column 226 is not finite");
  EXPECT_EQ(errorOf(multiPolygon("[[[[0,0],[8,-" + repeated("9", 400))),
            "feature 0, polygon 0, ring 0: the number -" + repeated("9", 59) +
                "... at line 1, column 128 is not finite");
  EXPECT_EQ(errorOf(polygon("[[[0,0],[1e101,8],[8,8],[0,0]]]")),
            "feature 1, ring 0 has a vertex at (1e+101, 8.0), accepted are coordinates of 1e-100 to 1e100 m "
            "either way, and 0");
}

TEST(GeoJsonRefusals, WhatFindDefectFinds)
{
  EXPECT_EQ(errorOf(polygon("[[[0,0],[8,0],[8,0],[8,8],[0,0]]]")),
            "feature 1, ring 0 repeats a vertex at (8, 0)");
  EXPECT_EQ(errorOf(polygon("[[[0,0],[4,4],[4,0],[0,4],[0,0]]]")),
            "feature 1, ring 0 crosses or touches itself at (2, 2)");
  EXPECT_EQ(errorOf(polygon("[[[0,0],[4,4],[8,8],[0,0]]]")),
            "feature 1, ring 0 crosses or touches itself at (4, 4)");
  EXPECT_EQ(errorOf(polygon("[[[0,0],[8,0],[8,8],[0,0]], [[5,1],[5,2],[9,2],[5,1]]]")),
            "feature 1, ring 0 meets feature 1, ring 1 at (8, 1.75)");
  EXPECT_EQ(errorOf(polygon("[[[0,0],[8,0],[8,8],[0,0]], [[5,11],[5,12],[6,12],[5,11]]]")),
            "feature 1, ring 1 is a hole outside of its boundary at (5, 11)");
  EXPECT_EQ(errorOf(polygon("[[[22,21],[23,21],[23,22],[22,21]]]")),
            "feature 1, ring 0 lies inside of the polygon of feature 0, ring 0 at (22, 21)");
  EXPECT_EQ(
      errorOf(multiPolygon("[[[[0,0],[8,0],[8,8],[0,0]]], [[[5,1],[6,1],[6,2],[5,1]]]]")),
      "feature 0, polygon 1, ring 0 lies inside of the polygon of feature 0, polygon 0, ring 0 at (5, 1)");
}

TEST(GeoJsonRefusals, Members)
{
  EXPECT_EQ(errorOf(members(R"("units": "feet")")), "units is \"feet\", accepted is \"metres\"");
  EXPECT_EQ(errorOf(members(R"("frame_id": ["map"])")), "frame_id is an array, accepted is a text");
  EXPECT_EQ(errorOf(members(R"("inflation_radius": "0.3")")),
            "inflation_radius is \"0.3\", accepted is a number");
  EXPECT_EQ(errorOf(members(R"("inflation_radius": -0.3)")),
            "inflation_radius is -0.3, accepted is a finite number from 0 [m]");
  EXPECT_EQ(errorOf(members(R"("inflation_radius": 1e400)")),
            "the number 1e400 at line 1, column 67 is not finite");
}

TEST(GeoJsonRefusals, TooManyValuesOrVertices)
{
  JsonLimits limits;
  limits.values = 100;
  EXPECT_EQ(errorOf(readLimited(members("\"more\": [" + repeated("0,", 1000) + "0]"), limits)),
            "there are more than 100 values");
  EXPECT_EQ(errorOf(readLimited(geometry(R"({"coordinates": [[)" + repeated("[0,0],", 1000)), limits)),
            "feature 0, ring 0: there are more than 100 values");
  EXPECT_EQ(errorOf(polygon("[[" + repeated("[0,0],", 1'000'010) + "[0,0]]]")),
            "there are 1000013 vertices, accepted are at most 1000000");
}

}  // namespace
}  // namespace polygonal_perception::mapping

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <locale>
#include <map>
#include <random>
#include <sstream>

#include "polygonal_perception/mapping/occupancy_image.hpp"
#include "support/temporary_folder.hpp"

namespace polygonal_perception::mapping {
namespace {

std::string contentsOf(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string textOf(const std::optional<MapFileError>& error)
{
  return error ? error->text : "none";
}

/// A grid as map_server publishes it.
struct ServedGrid
{
  int width = 0;
  int height = 0;
  double resolution = 0.0;
  double origin_x = 0.0;
  double origin_y = 0.0;
  double origin_yaw = 0.0;
  std::vector<std::int8_t> data;
};

/// What map_server does with a yaml: main.cpp's loadMapFromYaml, and image_loader.cpp's loadMapFromFile in its
/// mode trinary, on the one channel of a grey image.
ServedGrid serve(const std::string& yaml_path)
{
  std::map<std::string, std::string> yaml;
  std::istringstream lines(contentsOf(yaml_path));
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty()) yaml[line.substr(0, line.find(':'))] = line.substr(line.find(':') + 2);
  }
  ServedGrid grid;
  grid.resolution = std::stod(yaml.at("resolution"));
  std::sscanf(yaml.at("origin").c_str(), "[%lf, %lf, %lf]", &grid.origin_x, &grid.origin_y, &grid.origin_yaw);
  const double occupied_above = std::stod(yaml.at("occupied_thresh"));
  const double free_below = std::stod(yaml.at("free_thresh"));
  EXPECT_EQ(yaml.at("negate"), "0");
  EXPECT_EQ(yaml.count("mode"), 0U);

  // Relative to the yaml's folder. SDL_image skips comments of the header, and one byte after its last number.
  const std::string image = contentsOf(std::filesystem::path(yaml_path).parent_path() / yaml.at("image"));
  int most = 0;
  int header = 0;
  std::sscanf(image.c_str(), "P5\n#%*[^\n]\n%d %d\n%d%n", &grid.width, &grid.height, &most, &header);
  EXPECT_EQ(most, 255);
  const std::string pixels = image.substr(static_cast<std::size_t>(header) + 1);
  EXPECT_EQ(pixels.size(), static_cast<std::size_t>(grid.width * grid.height));
  grid.data.resize(pixels.size());
  const auto width = static_cast<std::size_t>(grid.width);
  const auto height = static_cast<std::size_t>(grid.height);
  for (std::size_t j = 0; j < height; ++j) {
    for (std::size_t i = 0; i < width; ++i) {
      const double occupied = (255 - static_cast<unsigned char>(pixels[j * width + i])) / 255.0;
      std::int8_t& value = grid.data[width * (height - j - 1) + i];
      value = occupied > occupied_above ? 100 : occupied < free_below ? 0 : -1;
    }
  }
  return grid;
}

class OccupancyImage : public testing::Test
{
protected:
  test::TemporaryFolder folder_;
};

TEST_F(OccupancyImage, BothFilesByteForByte)
{
  const std::vector<std::int8_t> values = {0,  100, -1,  // the row with the least y
                                           25, 26,  64,  //
                                           65, 127, -128};
  ASSERT_EQ(textOf(writeOccupancyImage(folder_.path("floor.v2"), 3, 3, 0.05, -1.25, 2.0, values)), "none");
  EXPECT_EQ(contentsOf(folder_.path("floor.v2.pgm")),
            std::string("P5\n# CREATOR: polygonal_perception 0.050 m/pix\n3 3\n255\n") +
                std::string("\x00\x00\xcd\xfe\xcd\xcd\xfe\x00\xcd", 9));
  EXPECT_EQ(contentsOf(folder_.path("floor.v2.yaml")),
            "image: floor.v2.pgm\nresolution: 0.050000\norigin: [-1.250000, 2.000000, 0.000000]\nnegate: 0\n"
            "occupied_thresh: 0.65\nfree_thresh: 0.196\n\n");
  EXPECT_EQ(folder_.names().size(), 2U);
}

TEST_F(OccupancyImage, MapServerReadsTheSameGridBack)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1000.0, 1000.0);
  constexpr std::int8_t kValues[] = {-1, 0, 100};
  for (int n = 0; n < 100; ++n) {
    const int width = 1 + static_cast<int>(random() % 50);
    const int height = 1 + static_cast<int>(random() % 50);
    std::vector<std::int8_t> values(static_cast<std::size_t>(width * height));
    for (std::int8_t& value : values) value = kValues[random() % 3];
    const double resolution = n % 2 == 0 ? 0.05 : static_cast<double>(0.05F + 0.01F * static_cast<float>(n));
    const double x = n % 3 == 0 ? -2.5 : coordinate(random);
    const double y = 1e-9 * coordinate(random);
    ASSERT_EQ(textOf(writeOccupancyImage(folder_.path("map"), width, height, resolution, x, y, values)),
              "none");
    const ServedGrid grid = serve(folder_.path("map.yaml"));
    EXPECT_EQ(grid.width, width);
    EXPECT_EQ(grid.height, height);
    EXPECT_EQ(grid.resolution, resolution);
    EXPECT_EQ(grid.origin_x, x);
    EXPECT_EQ(grid.origin_y, y);
    EXPECT_EQ(grid.origin_yaw, 0.0);
    ASSERT_EQ(grid.data, values) << width << " x " << height;
  }
}

TEST_F(OccupancyImage, NamesThatMeanSomethingInYaml)
{
  const auto image_line = [&](const std::string& name) {
    EXPECT_EQ(textOf(writeOccupancyImage(folder_.path(name), 1, 1, 0.05, 0.0, 0.0, {0})), "none");
    const std::string text = contentsOf(folder_.path(name + ".yaml"));
    return text.substr(0, text.find('\n'));
  };
  EXPECT_EQ(image_line("Map_1-a+b.c"), "image: Map_1-a+b.c.pgm");
  EXPECT_EQ(image_line("a: b #c"), "image: \"a: b #c.pgm\"");
  EXPECT_EQ(image_line("- a"), "image: \"- a.pgm\"");
  EXPECT_EQ(image_line("a\"b\\c\n\x7f"), R"(image: "a\"b\\c\x0a\x7f.pgm")");
  EXPECT_EQ(image_line("caf\u00e9"), "image: \"caf\u00e9.pgm\"");
}

TEST_F(OccupancyImage, WhateverTheLocaleIs)
{
  struct Comma : std::numpunct<char>
  {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  const auto error = writeOccupancyImage(folder_.path("map"), 1000, 1, 0.05, 1234.5, 0.1234567,
                                         std::vector<std::int8_t>(1000));
  std::locale::global(before);
  EXPECT_EQ(textOf(error), "none");
  EXPECT_EQ(contentsOf(folder_.path("map.pgm")).substr(0, 58),
            "P5\n# CREATOR: polygonal_perception 0.050 m/pix\n1000 1\n255\n");
  EXPECT_NE(contentsOf(folder_.path("map.yaml")).find("origin: [1234.500000, 0.1234567, 0.000000]"),
            std::string::npos);
}

TEST_F(OccupancyImage, WhatIsRefused)
{
  const std::string cannot = "cannot write " + folder_.path("map.pgm") + ": ";
  const auto error_of = [&](int cells_x, int cells_y, double resolution, double x, std::size_t values) {
    return textOf(writeOccupancyImage(folder_.path("map"), cells_x, cells_y, resolution, x, 0.0,
                                      std::vector<std::int8_t>(values)));
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error_of(0, 3, 0.05, 0.0, 0), cannot + "there are 0 x 3, accepted is at least 1 x 1");
  EXPECT_EQ(error_of(3, 3, 0.0, 0.0, 9),
            cannot + "resolution is 0.0, accepted is a finite number above 0 [m]");
  EXPECT_EQ(error_of(3, 3, 0.05, nan, 9),
            cannot + "the origin is (NaN, 0.0), accepted are finite numbers [m]");
  EXPECT_EQ(error_of(3, 3, 0.05, 0.0, 8), cannot + "there are 8 values, accepted are 3 x 3");
  EXPECT_EQ(folder_.names().size(), 0U);
}

TEST_F(OccupancyImage, BothOrNone)
{
  EXPECT_EQ(textOf(writeOccupancyImage(folder_.path("nowhere/map"), 1, 1, 0.05, 0.0, 0.0, {0})),
            "cannot write " + folder_.path("nowhere/map.pgm") + ": No such file or directory");
  // The longest name with .pgm is too long with .yaml: what is beside the image goes, and it does not take its place.
  const std::size_t left = 255 - std::string(".yaml").size() + 1;
  const std::string name(left, 'a');
  EXPECT_NE(textOf(writeOccupancyImage(folder_.path(name), 1, 1, 0.05, 0.0, 0.0, {0})), "none");
  EXPECT_EQ(folder_.names().size(), 0U);
}

}  // namespace
}  // namespace polygonal_perception::mapping

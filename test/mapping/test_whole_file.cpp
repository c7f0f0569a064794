#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "mapping/whole_file.hpp"
#include "polygonal_perception/mapping/geojson.hpp"
#include "support/same_map.hpp"
#include "support/temporary_folder.hpp"

namespace polygonal_perception::mapping {
namespace {

namespace fs = std::filesystem;

class WholeFile : public testing::Test
{
protected:
  std::string path(const std::string& name) const { return folder_.path(name); }

  std::string contentsOf(const std::string& name) const
  {
    const auto contents = readWhole(path(name), 1000);
    const auto* const error = std::get_if<MapFileError>(&contents);
    return error == nullptr ? std::get<std::string>(contents) : "error: " + error->text;
  }

  std::vector<std::string> names() const { return folder_.names(); }

private:
  test::TemporaryFolder folder_;
};

std::string textOf(const std::optional<MapFileError>& error)
{
  return error ? error->text : "none";
}

TEST_F(WholeFile, TakesThePlaceOfAnother)
{
  const std::string contents("new\0\r\n\xff", 7);
  std::ofstream(path("map")) << "old and longer";
  EXPECT_EQ(textOf(writeWhole(path("map"), contents)), "none");
  EXPECT_EQ(contentsOf("map"), contents);
  EXPECT_EQ(names(), std::vector<std::string>{"map"});
}

TEST_F(WholeFile, MayBeReadByWhomTheUmaskLets)
{
  const mode_t before = umask(022);
  EXPECT_EQ(textOf(writeWhole(path("map"), "")), "none");
  umask(before);
  EXPECT_EQ(fs::status(path("map")).permissions(), static_cast<fs::perms>(0644));
}

TEST_F(WholeFile, TheOldOneStaysUntilTheNewOneIsComplete)
{
  std::ofstream(path("map")) << "old";
  {
    PendingFile file(path("map"));
    EXPECT_EQ(textOf(file.write("new")), "none");
    EXPECT_EQ(contentsOf("map"), "old");
    EXPECT_EQ(names().size(), 2U);
  }
  EXPECT_EQ(contentsOf("map"), "old");
  EXPECT_EQ(names(), std::vector<std::string>{"map"});
}

TEST_F(WholeFile, TwoAtATime)
{
  PendingFile one(path("map"));
  PendingFile other(path("map"));
  EXPECT_EQ(textOf(one.write("one")), "none");
  EXPECT_EQ(textOf(other.write("other")), "none");
  EXPECT_EQ(textOf(one.takePlace()), "none");
  EXPECT_EQ(contentsOf("map"), "one");
  EXPECT_EQ(textOf(other.takePlace()), "none");
  EXPECT_EQ(contentsOf("map"), "other");
}

TEST_F(WholeFile, ErrorsNameThePath)
{
  const std::string nowhere = path("nowhere/map");
  EXPECT_EQ(textOf(writeWhole(nowhere, "new")), "cannot write " + nowhere + ": No such file or directory");
  fs::create_directory(path("folder"));
  EXPECT_EQ(textOf(writeWhole(path("folder"), "new")), "cannot write " + path("folder") + ": Is a directory");
  EXPECT_EQ(names(), std::vector<std::string>{"folder"}) << "what was beside it is gone";
  EXPECT_EQ(textOf(writeWhole(path(std::string(300, 'a')), "")),
            "cannot write " + path(std::string(300, 'a')) + ": File name too long");
}

TEST_F(WholeFile, AFullDiscLeavesTheOldOne)
{
  std::ofstream(path("map")) << "old";
  // As a full disc does it: some bytes go, and then none.
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit little{5000, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &little);
  const std::string text = textOf(writeWhole(path("map"), std::string(10'000, 'x')));
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(text, "cannot write " + path("map") + ": File too large");
  EXPECT_EQ(contentsOf("map"), "old");
  EXPECT_EQ(names(), std::vector<std::string>{"map"});
}

TEST_F(WholeFile, WhatIsNoFileIsNotRead)
{
  EXPECT_EQ(contentsOf("nothing"), "error: cannot read " + path("nothing") + ": No such file or directory");
  fs::create_directory(path("folder"));
  EXPECT_EQ(contentsOf("folder"), "error: cannot read " + path("folder") + ": it is no file");
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  EXPECT_EQ(contentsOf("pipe"), "error: cannot read " + path("pipe") + ": it is no file");
  EXPECT_EQ(std::get<MapFileError>(readWhole("/dev/zero", 1000)).text,
            "cannot read /dev/zero: it is no file");
  std::ofstream(path("large")) << std::string(1001, ' ');
  EXPECT_EQ(contentsOf("large"),
            "error: cannot read " + path("large") + ": it has 1001 bytes, accepted are at most 1000");
}

TEST_F(WholeFile, OfGeoJson)
{
  MapFile map;
  map.frame_id = "map";
  map.polygons.append(std::vector<Eigen::Vector2d>{{0, 0}, {8, 0}, {8, 8}}, false);
  EXPECT_EQ(textOf(writeGeoJsonFile(path("map"), map)), "none");
  const auto read = readGeoJsonFile(path("map"));
  ASSERT_TRUE(std::holds_alternative<MapFile>(read)) << std::get<MapFileError>(read).text;
  EXPECT_EQ(test::difference(map, std::get<MapFile>(read)), "");

  map.inflation_radius = -1.0;
  EXPECT_EQ(
      textOf(writeGeoJsonFile(path("map"), map)),
      "cannot write " + path("map") + ": inflation_radius is -1.0, accepted is a finite number from 0 [m]");
  EXPECT_EQ(textOf(writeGeoJsonFile(path("nowhere/map"), {})),
            "cannot write " + path("nowhere/map") + ": No such file or directory");
  EXPECT_EQ(std::get<MapFileError>(readGeoJsonFile(path("nothing"))).text,
            "cannot read " + path("nothing") + ": No such file or directory");
  std::ofstream(path("bad")) << "{";
  EXPECT_EQ(std::get<MapFileError>(readGeoJsonFile(path("bad"))).text,
            "cannot read " + path("bad") + ": the text ends too early, at line 1, column 2");
}

}  // namespace
}  // namespace polygonal_perception::mapping

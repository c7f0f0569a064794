// The source through the real OpenNI2, on the virtual device.
#include <gtest/gtest.h>
#include <unistd.h>

#include "collected_frames.hpp"
#include "plug.hpp"
#include "rendered_frames.hpp"

namespace polygonal_perception::openni2 {
namespace {

using virtual_device::indexOf;
using virtual_device::RenderedFrames;

SourceOptions small()
{
  SourceOptions options;
  options.width = 320;
  options.height = 240;
  return options;
}

void compareIntrinsics(const CollectedFrame& frame, const simulation::PinholeCamera& camera)
{
  EXPECT_NEAR(frame.focal_length, camera.fx, 1e-3);
  EXPECT_NEAR(0.5 * (camera.width - 1.0) + frame.offset_x, camera.cx, 1e-9);
  EXPECT_NEAR(0.5 * (camera.height - 1.0) + frame.offset_y, camera.cy, 1e-9);
}

class Source : public testing::Test
{
protected:
  Source() : plug_("/tmp/virtual_plug_" + std::to_string(getpid()))
  {
    setenv(virtual_device::kPlug, ("/tmp/virtual_plug_" + std::to_string(getpid())).c_str(), 1);
    plug_.putIn();
  }

  virtual_device::Plug plug_;
};

TEST_F(Source, GivesTheFramesOfTheDeviceBitForBit)
{
  CollectingSource source(small());
  source.setStreaming(true);
  ASSERT_TRUE(source.waitForFrames(10)) << source.reports();
  RenderedFrames rendered({320, 240, 30});
  for (const CollectedFrame& frame : source.frames()) {
    EXPECT_EQ(frame.width, 320U);
    EXPECT_EQ(frame.height, 240U);
    compareIntrinsics(frame, rendered.camera().options().camera);
    EXPECT_TRUE(frame.depth == rendered.depth(indexOf(frame.timestamp))) << "at " << frame.timestamp << " us";
  }
}

TEST_F(Source, FollowsTheRateOfTheMode)
{
  SourceOptions options = small();
  options.width = 160;
  options.height = 120;
  options.rate = 60;
  CollectingSource source(options);
  source.setStreaming(true);
  ASSERT_TRUE(source.waitForFrames(5)) << source.reports();
  RenderedFrames rendered({160, 120, 60});
  for (const CollectedFrame& frame : source.frames()) {
    compareIntrinsics(frame, rendered.camera().options().camera);
    EXPECT_TRUE(frame.depth == rendered.depth(indexOf(frame.timestamp, 60)))
        << "at " << frame.timestamp << " us";
  }
}

TEST_F(Source, MirrorsWhereAsked)
{
  SourceOptions options = small();
  options.mirror = true;
  CollectingSource source(options);
  source.setStreaming(true);
  ASSERT_TRUE(source.waitForFrames(1)) << source.reports();
  const CollectedFrame frame = source.frames().front();
  RenderedFrames rendered({320, 240, 30});
  simulation::PinholeCamera camera = rendered.camera().options().camera;
  camera.cx = 319.0 - camera.cx;
  compareIntrinsics(frame, camera);
  const Depth plain = rendered.depth(indexOf(frame.timestamp));
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const std::size_t row = i / 320;
    ASSERT_EQ(frame.depth[i], plain[row * 320 + 319 - i % 320]) << "pixel " << i;
  }
}

TEST_F(Source, StreamsOnlyWhileFramesAreWanted)
{
  CollectingSource source(small());
  ASSERT_TRUE(source.waitForReport("opened virtual@1/1")) << source.reports();
  EXPECT_TRUE(source.frames().empty());
  source.setStreaming(true);
  ASSERT_TRUE(source.waitForFrames(3)) << source.reports();
  source.setStreaming(false);
  source.setStreaming(true);
  source.clear();
  ASSERT_TRUE(source.waitForFrames(3)) << source.reports();
}

TEST_F(Source, SurvivesAnUnplugAndAReplug)
{
  CollectingSource source(small());
  source.setStreaming(true);
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(source.waitForFrames(2)) << source.reports();
    plug_.pull();
    ASSERT_TRUE(source.waitForReport("virtual@1/1 has gone")) << source.reports();
    ASSERT_TRUE(source.waitForReport("OpenNI2 sees none at all")) << source.reports();
    source.clear();
    plug_.putIn();
  }
  ASSERT_TRUE(source.waitForFrames(2)) << source.reports();
}

TEST_F(Source, NoticesAnUnplugWhileNobodyReads)
{
  CollectingSource source(small());
  ASSERT_TRUE(source.waitForReport("opened")) << source.reports();
  plug_.pull();
  ASSERT_TRUE(source.waitForReport("has gone")) << source.reports();
  source.setStreaming(true);
  plug_.putIn();
  ASSERT_TRUE(source.waitForFrames(2)) << source.reports();
}

TEST_F(Source, WaitsForADeviceThatIsNotThereYet)
{
  plug_.pull();
  CollectingSource source(small());
  source.setStreaming(true);
  ASSERT_TRUE(source.waitForReport("OpenNI2 sees none at all")) << source.reports();
  plug_.putIn();
  ASSERT_TRUE(source.waitForFrames(2)) << source.reports();
}

TEST_F(Source, FindsADeviceByEachOfItsNames)
{
  for (const char* name :
       {"", "#1", "1@1", "1@0", "virtual", "@1/1", virtual_device::kUri, virtual_device::kSerialNumber}) {
    SourceOptions options = small();
    options.device_id = name;
    CollectingSource source(options);
    EXPECT_TRUE(source.waitForReport("opened virtual@1/1")) << "'" << name << "': " << source.reports();
  }
}

TEST_F(Source, NamesTheDevicesThereAreForOneThatIsNot)
{
  for (const char* name : {"#2", "#0", "#x", "2@1", "1d27/0601@3/18", "/nonexistent/recording.oni"}) {
    SourceOptions options = small();
    options.device_id = name;
    CollectingSource source(options);
    EXPECT_TRUE(source.waitForReport("there is no OpenNI2 device '" + std::string(name) +
                                     "'; OpenNI2 sees virtual@1/1"))
        << "'" << name << "': " << source.reports();
  }
}

TEST_F(Source, NamesTheModesThereAreForOneThatIsNot)
{
  SourceOptions options = small();
  options.rate = 15;
  CollectingSource source(options);
  EXPECT_TRUE(
      source.waitForReport("no depth mode 320x240 at 15 Hz; it has 320x240 at 30 Hz, 640x480 at 30 Hz"))
      << source.reports();
}

TEST_F(Source, TellsTheSerialNumberAndRegistersWhereTheDeviceCan)
{
  SourceOptions options = small();
  options.registration = true;
  CollectingSource source(options);
  source.setStreaming(true);
  ASSERT_TRUE(source.waitForFrames(1)) << source.reports();
  const CollectedFrame frame = source.frames().front();
  EXPECT_EQ(frame.serial, virtual_device::kSerialNumber);
  RenderedFrames rendered({320, 240, 30}, virtual_device::View::kColor);
  compareIntrinsics(frame, rendered.camera().options().camera);
  EXPECT_TRUE(frame.depth == rendered.depth(indexOf(frame.timestamp))) << "at " << frame.timestamp << " us";
}

TEST_F(Source, SaysThatTheDeviceCannotRegister)
{
  setenv(virtual_device::kColorless, "1", 1);
  SourceOptions options = small();
  options.registration = true;
  CollectingSource source(options);
  EXPECT_TRUE(source.waitForReport("cannot register depth to colour")) << source.reports();
  unsetenv(virtual_device::kColorless);
}

}  // namespace
}  // namespace polygonal_perception::openni2

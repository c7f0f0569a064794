// .oni files, written by OpenNI2's own recorder and played by its own driver.
#include <OpenNI.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "collected_frames.hpp"
#include "plug.hpp"
#include "rendered_frames.hpp"

namespace polygonal_perception::openni2 {
namespace {

using virtual_device::RenderedFrames;

/// Records that many frames of the virtual device.
void record(const std::string& path, int frames)
{
  ASSERT_EQ(openni::OpenNI::initialize(), openni::STATUS_OK) << openni::OpenNI::getExtendedError();
  {
    openni::Device device;
    ASSERT_EQ(device.open(virtual_device::kUri), openni::STATUS_OK) << openni::OpenNI::getExtendedError();
    openni::VideoStream stream;
    ASSERT_EQ(stream.create(device, openni::SENSOR_DEPTH), openni::STATUS_OK);
    ASSERT_EQ(stream.setMirroringEnabled(false), openni::STATUS_OK);
    openni::Recorder recorder;
    ASSERT_EQ(recorder.create(path.c_str()), openni::STATUS_OK);
    ASSERT_EQ(recorder.attach(stream), openni::STATUS_OK);
    ASSERT_EQ(recorder.start(), openni::STATUS_OK);
    ASSERT_EQ(stream.start(), openni::STATUS_OK);
    openni::VideoFrameRef frame;
    for (int i = 0; i < frames; ++i) ASSERT_EQ(stream.readFrame(&frame), openni::STATUS_OK);
    frame.release();
    stream.stop();
    recorder.stop();
    recorder.destroy();
    stream.destroy();
    device.close();
  }
  openni::OpenNI::shutdown();
}

class Recording : public testing::Test
{
protected:
  void SetUp() override
  {
    unsetenv(virtual_device::kPlug);
    path_ = "/tmp/recording_" + std::to_string(getpid()) + ".oni";
    ASSERT_NO_FATAL_FAILURE(record(path_, 20));
    ASSERT_GT(std::filesystem::file_size(path_), 0U);
  }
  void TearDown() override { std::filesystem::remove(path_); }

  SourceOptions options(bool loop) const
  {
    SourceOptions options;
    options.device_id = path_;
    options.loop = loop;
    return options;
  }

  std::string path_;
};

TEST_F(Recording, ComesBackBitForBit)
{
  CollectingSource source(options(false));
  source.setStreaming(true);
  ASSERT_TRUE(source.waitForReport("has been played to its end")) << source.reports();
  const std::vector<CollectedFrame> frames = source.frames();
  ASSERT_GE(frames.size(), 10U) << source.reports();

  // The player begins again, which nobody is to see.
  for (std::size_t i = 1; i < frames.size(); ++i)
    EXPECT_GT(frames[i].timestamp, frames[i - 1].timestamp) << "frame " << i;

  // The recorder lets the first few pass, and counts the stamps from its first.
  RenderedFrames rendered({320, 240, 30});
  std::uint32_t first = 0;
  while (first < 20 && rendered.depth(first) != frames.front().depth) ++first;
  ASSERT_LT(first, 20U) << "the first frame of the recording is none of the rendered ones";
  for (const CollectedFrame& frame : frames) {
    const std::uint32_t index = first + virtual_device::indexOf(frame.timestamp - frames.front().timestamp);
    EXPECT_TRUE(frame.depth == rendered.depth(index)) << "frame " << index;
    EXPECT_NEAR(frame.focal_length, rendered.camera().options().camera.fx, 1e-3);
  }
}

TEST_F(Recording, StaysAtItsEndWhenFramesAreWantedAnew)
{
  CollectingSource source(options(false));
  source.setStreaming(true);
  ASSERT_TRUE(source.waitForReport("has been played to its end")) << source.reports();
  const std::size_t played = source.frames().size();
  source.setStreaming(false);
  source.setStreaming(true);
  // As long as a copy of the recording takes: on a machine that is busy, both are slower.
  const std::string copy = path_ + ".copy.oni";
  std::filesystem::copy_file(path_, copy);
  SourceOptions of_copy = options(false);
  of_copy.device_id = copy;
  CollectingSource other(of_copy);
  other.setStreaming(true);
  const bool over = other.waitForReport("has been played to its end");
  std::filesystem::remove(copy);
  ASSERT_TRUE(over) << other.reports();
  EXPECT_EQ(source.frames().size(), played);
}

TEST_F(Recording, BeginsAgainWhereAsked)
{
  CollectingSource source(options(true));
  source.setStreaming(true);
  ASSERT_TRUE(source.waitForFrames(60)) << source.reports();
  int beginnings = 0;
  const std::vector<CollectedFrame> frames = source.frames();
  for (std::size_t i = 1; i < frames.size(); ++i)
    beginnings += frames[i].timestamp < frames[i - 1].timestamp ? 1 : 0;
  EXPECT_GE(beginnings, 1);
}

}  // namespace
}  // namespace polygonal_perception::openni2

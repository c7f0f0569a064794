// The virtual device as openni2_camera uses a device: the same calls, in the same order, each with the answer
// that it needs. That driver is not in Debian; with it this device stands for an ASUS Xtion Pro Live.
#include <OpenNI.h>
#include <PS1080.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstring>
#include <mutex>
#include <string>
#include <vector>

#include "plug.hpp"
#include "rendered_frames.hpp"

namespace polygonal_perception::virtual_device {
namespace {

using openni::STATUS_OK;

std::string error()
{
  return openni::OpenNI::getExtendedError();
}

/// Keeps the frames of a stream, and reads each when it is told of it.
class Listener : public openni::VideoStream::NewFrameListener
{
public:
  struct Frame
  {
    std::uint64_t timestamp;  // [us]
    openni::VideoMode mode;
    std::vector<std::uint16_t> depth;  // [mm]
  };

  void onNewFrame(openni::VideoStream& stream) override
  {
    // A thread that comes late is told twice of one frame, and would wait here for the next, for ever where
    // the stream is stopped. OpenNI cancels a thread that it has waited for in vain, and the unwinding
    // destroys the stream, which is OpenNI's own class around this call, beside the thread that destroys it
    // anyway.
    openni::VideoStream* streams[] = {&stream};
    int ready = 0;
    if (openni::OpenNI::waitForAnyStream(streams, 1, &ready, openni::TIMEOUT_NONE) != STATUS_OK) return;
    openni::VideoFrameRef ref;
    if (stream.readFrame(&ref) != STATUS_OK) return;
    Frame frame{ref.getTimestamp(), ref.getVideoMode(), {}};
    frame.depth.resize(static_cast<std::size_t>(ref.getDataSize()) / sizeof(std::uint16_t));
    std::memcpy(frame.depth.data(), ref.getData(), frame.depth.size() * sizeof(std::uint16_t));
    const std::lock_guard<std::mutex> lock(mutex_);
    frames_.push_back(std::move(frame));
    changed_.notify_all();
  }
  /// Waits until there are that many frames of a size since it was called.
  std::vector<Frame> next(std::size_t count, int width)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    frames_.clear();
    const auto chosen = [&] {
      std::vector<Frame> some;
      for (const Frame& frame : frames_) {
        if (frame.mode.getResolutionX() == width) some.push_back(frame);
      }
      return some;
    };
    changed_.wait_for(lock, std::chrono::seconds(30), [&] { return chosen().size() >= count; });
    return chosen();
  }
  /// Whether none comes for 0.7 s, once those are there that were under way.
  bool isSilent()
  {
    std::unique_lock<std::mutex> lock(mutex_);
    for (int i = 0; i < 5; ++i) {
      frames_.clear();
      if (!changed_.wait_for(lock, std::chrono::milliseconds(700), [&] { return !frames_.empty(); }))
        return true;
    }
    return false;
  }

private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Frame> frames_;
};

/// What openni2_camera follows the devices by.
class Connections : public openni::OpenNI::DeviceConnectedListener,
                    public openni::OpenNI::DeviceDisconnectedListener
{
public:
  Connections()
  {
    openni::OpenNI::addDeviceConnectedListener(this);
    openni::OpenNI::addDeviceDisconnectedListener(this);
  }
  ~Connections() override
  {
    openni::OpenNI::removeDeviceConnectedListener(this);
    openni::OpenNI::removeDeviceDisconnectedListener(this);
  }
  void onDeviceConnected(const openni::DeviceInfo* /*info*/) override { change(true); }
  void onDeviceDisconnected(const openni::DeviceInfo* /*info*/) override { change(false); }

  bool waitFor(bool connected)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    return changed_.wait_for(lock, std::chrono::seconds(30), [&] { return connected_ == connected; });
  }

private:
  void change(bool connected)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    connected_ = connected;
    changed_.notify_all();
  }
  std::mutex mutex_;
  std::condition_variable changed_;
  bool connected_ = true;
};

void compare(const Listener::Frame& frame, RenderedFrames& rendered, int rate)
{
  EXPECT_TRUE(frame.depth == rendered.depth(indexOf(frame.timestamp, rate)))
      << "at " << frame.timestamp << " us";
}

class VirtualDevice : public testing::Test
{
protected:
  VirtualDevice() : plug_("/tmp/virtual_device_plug_" + std::to_string(getpid()))
  {
    setenv(kPlug, ("/tmp/virtual_device_plug_" + std::to_string(getpid())).c_str(), 1);
    plug_.putIn();
  }
  void SetUp() override
  {
    ASSERT_EQ(openni::OpenNI::initialize(), STATUS_OK) << error();
    ASSERT_EQ(device_.open(kUri), STATUS_OK) << error();
  }
  void TearDown() override
  {
    depth_.removeNewFrameListener(&listener_);
    depth_.destroy();
    device_.close();
    openni::OpenNI::shutdown();
    unsetenv(kPlug);
  }

  openni::VideoMode mode(const Mode& asked)
  {
    openni::VideoMode mode;
    mode.setResolution(asked.width, asked.height);
    mode.setFps(asked.rate);
    mode.setPixelFormat(openni::PIXEL_FORMAT_DEPTH_1_MM);
    return mode;
  }
  /// In openni2_camera's order: it listens after the start.
  void startDepth(const Mode& asked)
  {
    ASSERT_EQ(depth_.create(device_, openni::SENSOR_DEPTH), STATUS_OK) << error();
    ASSERT_EQ(depth_.setVideoMode(mode(asked)), STATUS_OK) << error();
    ASSERT_EQ(depth_.setMirroringEnabled(false), STATUS_OK) << error();
    ASSERT_EQ(depth_.start(), STATUS_OK) << error();
    ASSERT_EQ(depth_.addNewFrameListener(&listener_), STATUS_OK) << error();
  }

  Plug plug_;
  Listener listener_;
  openni::Device device_;
  openni::VideoStream depth_;
};

TEST_F(VirtualDevice, TellsItsNamesAndSerialNumberAlsoToASecondHandle)
{
  EXPECT_STREQ(device_.getDeviceInfo().getUri(), "virtual@1/1");  // <anything>@<bus>/<number>
  // What becomes the camera's name, for camera_info_manager, is made of these.
  for (const std::string part : {device_.getDeviceInfo().getName(), device_.getDeviceInfo().getVendor()})
    EXPECT_EQ(part.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_"),
              std::string::npos)
        << part;
  openni::Device second;
  ASSERT_EQ(second.open(kUri), STATUS_OK) << error();
  char serial[100];
  int size = sizeof serial;
  EXPECT_EQ(second.getProperty(openni::DEVICE_PROPERTY_SERIAL_NUMBER, serial, &size), STATUS_OK) << error();
  EXPECT_STREQ(serial, kSerialNumber);
  second.close();
  EXPECT_TRUE(device_.isValid());
}

TEST_F(VirtualDevice, HasThreeSensorsWithTheModesThatAreAskedFor)
{
  const std::pair<openni::SensorType, openni::PixelFormat> sensors[] = {
      {openni::SENSOR_DEPTH, openni::PIXEL_FORMAT_DEPTH_1_MM},
      {openni::SENSOR_COLOR, openni::PIXEL_FORMAT_RGB888},
      {openni::SENSOR_IR, openni::PIXEL_FORMAT_GRAY16}};
  for (const auto& sensor : sensors) {
    SCOPED_TRACE("sensor " + std::to_string(sensor.first));
    ASSERT_TRUE(device_.hasSensor(sensor.first));
    openni::VideoStream stream;
    ASSERT_EQ(stream.create(device_, sensor.first), STATUS_OK) << error();
    const auto& modes = stream.getSensorInfo().getSupportedVideoModes();
    for (const Mode& wanted : kModes) {
      const std::string name = std::to_string(wanted.width) + " at " + std::to_string(wanted.rate);
      bool is_there = false;
      for (int i = 0; i < modes.getSize(); ++i) {
        is_there |= modes[i].getResolutionX() == wanted.width && modes[i].getResolutionY() == wanted.height &&
                    modes[i].getFps() == wanted.rate && modes[i].getPixelFormat() == sensor.second;
      }
      EXPECT_TRUE(is_there) << name;
      openni::VideoMode mode = this->mode(wanted);
      mode.setPixelFormat(sensor.second);
      EXPECT_EQ(stream.setVideoMode(mode), STATUS_OK) << name << ": " << error();
      EXPECT_EQ(stream.getVideoMode().getFps(), wanted.rate) << name;
      // Its way to the focal length.
      const auto view = sensor.first == openni::SENSOR_COLOR ? View::kColor : View::kInfrared;
      EXPECT_NEAR(wanted.height / (2.0 * std::tan(stream.getVerticalFieldOfView() / 2.0)),
                  pinhole(view, wanted.width, wanted.height).fy, 1e-3)
          << name;
    }
  }
}

TEST_F(VirtualDevice, AnswersToTheRestOfTheConfiguration)
{
  EXPECT_EQ(device_.setDepthColorSyncEnabled(true), STATUS_OK) << error();
  openni::VideoStream color;
  ASSERT_EQ(color.create(device_, openni::SENSOR_COLOR), STATUS_OK) << error();
  // It sets exposure and white balance where there are such settings, and takes a baseline for granted where
  // the distance of the emitter (PS1080.h) is not told.
  EXPECT_EQ(color.getCameraSettings(), nullptr);
  ASSERT_NO_FATAL_FAILURE(startDepth({320, 240, 30}));
  EXPECT_FALSE(depth_.isPropertySupported(XN_STREAM_PROPERTY_EMITTER_DCMOS_DISTANCE));
  ASSERT_EQ(color.start(), STATUS_OK) << error();
  EXPECT_FALSE(listener_.next(3, 320).empty()) << "with colour in step";
  color.destroy();
  EXPECT_EQ(device_.setDepthColorSyncEnabled(false), STATUS_OK) << error();
  EXPECT_FALSE(listener_.next(3, 320).empty()) << "alone again";
}

TEST_F(VirtualDevice, ChangesItsModeAndItsViewWhileItStreams)
{
  ASSERT_NO_FATAL_FAILURE(startDepth(kModes[0]));
  std::uint64_t last = 0;
  for (const Mode& asked : {Mode{160, 120, 60}, Mode{640, 480, 30}, Mode{320, 240, 25}}) {
    SCOPED_TRACE(std::to_string(asked.width) + " at " + std::to_string(asked.rate));
    ASSERT_EQ(depth_.setVideoMode(mode(asked)), STATUS_OK) << error();
    const std::vector<Listener::Frame> frames = listener_.next(3, asked.width);
    ASSERT_GE(frames.size(), 3U);
    RenderedFrames rendered(asked);
    for (const Listener::Frame& frame : frames) {
      EXPECT_GT(frame.timestamp, last);
      last = frame.timestamp;
      compare(frame, rendered, asked.rate);
    }
  }
  ASSERT_TRUE(device_.isImageRegistrationModeSupported(openni::IMAGE_REGISTRATION_DEPTH_TO_COLOR));
  ASSERT_EQ(device_.setImageRegistrationMode(openni::IMAGE_REGISTRATION_DEPTH_TO_COLOR), STATUS_OK)
      << error();
  EXPECT_EQ(device_.getImageRegistrationMode(), openni::IMAGE_REGISTRATION_DEPTH_TO_COLOR);
  RenderedFrames rendered({320, 240, 25}, View::kColor);
  // Some may have been under way.
  const std::vector<Listener::Frame> frames = listener_.next(6, 320);
  ASSERT_GE(frames.size(), 6U);
  compare(frames.back(), rendered, 25);
  ASSERT_EQ(device_.setImageRegistrationMode(openni::IMAGE_REGISTRATION_OFF), STATUS_OK) << error();
}

TEST_F(VirtualDevice, HasAClockThatGoesOnWhileNothingStreams)
{
  ASSERT_NO_FATAL_FAILURE(startDepth({320, 240, 30}));
  ASSERT_FALSE(listener_.next(1, 320).empty());
  const auto begin = std::chrono::steady_clock::now();
  const std::uint64_t before = listener_.next(1, 320).back().timestamp;
  depth_.removeNewFrameListener(&listener_);
  depth_.stop();
  EXPECT_TRUE(listener_.isSilent());
  ASSERT_EQ(depth_.start(), STATUS_OK) << error();
  ASSERT_EQ(depth_.addNewFrameListener(&listener_), STATUS_OK) << error();
  const std::vector<Listener::Frame> frames = listener_.next(1, 320);
  ASSERT_FALSE(frames.empty());
  const std::chrono::duration<double, std::micro> longest = std::chrono::steady_clock::now() - begin;
  EXPECT_GT(frames.front().timestamp, before + 600000);
  EXPECT_LT(frames.front().timestamp, before + static_cast<std::uint64_t>(longest.count()) + 5000000);
}

TEST_F(VirtualDevice, IsDeadOncePulledAndAnotherWhenItIsBack)
{
  Connections connections;
  ASSERT_NO_FATAL_FAILURE(startDepth({320, 240, 30}));
  ASSERT_FALSE(listener_.next(1, 320).empty());
  plug_.pull();
  ASSERT_TRUE(connections.waitFor(false));
  EXPECT_TRUE(listener_.isSilent());
  plug_.putIn();
  ASSERT_TRUE(connections.waitFor(true));
  EXPECT_TRUE(listener_.isSilent()) << "the handle of before has come back to life";
  // All is stopped twice: by hand, and when the device is let go.
  for (int i = 0; i < 2; ++i) {
    depth_.removeNewFrameListener(&listener_);
    depth_.stop();
  }
  depth_.destroy();
  device_.close();
  ASSERT_EQ(device_.open(kUri), STATUS_OK) << error();
  ASSERT_NO_FATAL_FAILURE(startDepth({320, 240, 30}));
  EXPECT_FALSE(listener_.next(1, 320).empty());
}

TEST_F(VirtualDevice, HasNoColorWhereThatIsAskedFor)
{
  device_.close();
  setenv(kColorless, "1", 1);
  const openni::Status status = device_.open(kUri);
  unsetenv(kColorless);
  ASSERT_EQ(status, STATUS_OK) << error();
  EXPECT_TRUE(device_.hasSensor(openni::SENSOR_DEPTH));
  EXPECT_TRUE(device_.hasSensor(openni::SENSOR_IR));
  EXPECT_FALSE(device_.hasSensor(openni::SENSOR_COLOR));
  EXPECT_FALSE(device_.isImageRegistrationModeSupported(openni::IMAGE_REGISTRATION_DEPTH_TO_COLOR));
}

}  // namespace
}  // namespace polygonal_perception::virtual_device

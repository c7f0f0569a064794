#include "cameras/openni2/depth_stream.hpp"

#include <cctype>
#include <cmath>

#include "cameras/openni2/device_list.hpp"

namespace polygonal_perception::openni2 {
namespace {

/// [px at VGA] PrimeSense's sensors correlate in a window of about 9x9 pixels, which moves their depth image
/// against the infrared one by half of it (http://wiki.ros.org/kinect_calibration/technical). The figures are
/// openni2_camera's (depth_ir_offset_x, depth_ir_offset_y): both drivers tell the same.
constexpr double kCorrelationOffsetX = 5.0;
constexpr double kCorrelationOffsetY = 4.0;

std::string failure(const std::string& what)
{
  // OpenNI ends its texts with line breaks.
  std::string reason = openni::OpenNI::getExtendedError();
  while (!reason.empty() && std::isspace(static_cast<unsigned char>(reason.back())) != 0) reason.pop_back();
  return what + (reason.empty() ? "" : ": " + reason);
}

std::string toText(const openni::VideoMode& mode)
{
  return std::to_string(mode.getResolutionX()) + "x" + std::to_string(mode.getResolutionY()) + " at " +
         std::to_string(mode.getFps()) + " Hz";
}

}  // namespace

std::string DepthStream::open(const SourceOptions& options)
{
  const DeviceChoice choice = chooseDevice(options.device_id);
  if (choice.uri.empty()) return choice.error;
  if (device_.open(choice.uri.c_str()) != openni::STATUS_OK) return failure("cannot open " + choice.uri);
  uri_ = choice.uri;
  registered_ = options.registration;
  loop_ = options.loop;
  last_index_ = -1;
  serial_ = serialNumber(device_);
  std::string error = configure(options);
  if (!error.empty()) close();
  return error;
}

std::string DepthStream::configure(const SourceOptions& options)
{
  if (stream_.create(device_, openni::SENSOR_DEPTH) != openni::STATUS_OK)
    return failure(uri_ + " gives no depth stream");
  if (isFile()) {
    // Always: at the end of a file that does not repeat, OpenNI's player turns in an empty loop over its streams
    // without a lock, and crashes now and then when they are destroyed (13 of 216 times on a busy machine).
    device_.getPlaybackControl()->setRepeatEnabled(true);
    return {};
  }
  if (options.registration) {
    const auto mode = openni::IMAGE_REGISTRATION_DEPTH_TO_COLOR;
    if (!device_.isImageRegistrationModeSupported(mode)) return uri_ + " cannot register depth to colour";
    if (device_.setImageRegistrationMode(mode) != openni::STATUS_OK)
      return failure(uri_ + " refuses to register depth to colour");
    if (color_.create(device_, openni::SENSOR_COLOR) != openni::STATUS_OK)
      return failure(uri_ + " does not tell the colour camera's field of view");
  }
  std::string error = setMode(options);
  if (!error.empty()) return error;
  if (stream_.isPropertySupported(openni::STREAM_PROPERTY_MIRRORING) &&
      stream_.setMirroringEnabled(options.mirror) != openni::STATUS_OK)
    return failure(uri_ + " refuses to set mirroring");
  return {};
}

std::string DepthStream::setMode(const SourceOptions& options)
{
  std::string seen;
  const openni::Array<openni::VideoMode>& modes = stream_.getSensorInfo().getSupportedVideoModes();
  for (int i = 0; i < modes.getSize(); ++i) {
    const openni::VideoMode& mode = modes[i];
    if (mode.getPixelFormat() != openni::PIXEL_FORMAT_DEPTH_1_MM) continue;
    if (mode.getResolutionX() == options.width && mode.getResolutionY() == options.height &&
        mode.getFps() == options.rate) {
      return stream_.setVideoMode(mode) == openni::STATUS_OK
                 ? std::string()
                 : failure(uri_ + " refuses the mode " + toText(mode));
    }
    seen += (seen.empty() ? "" : ", ") + toText(mode);
  }
  return uri_ + " has no depth mode " + std::to_string(options.width) + "x" + std::to_string(options.height) +
         " at " + std::to_string(options.rate) + " Hz; it has " +
         (seen.empty() ? "none in millimetres" : seen);
}

std::string DepthStream::description() const
{
  return uri_ + ", " + device_.getDeviceInfo().getVendor() + " " + device_.getDeviceInfo().getName() + ", " +
         toText(stream_.getVideoMode());
}

void DepthStream::close()
{
  frame_.release();
  color_.destroy();
  stream_.destroy();
  device_.close();
  uri_.clear();
}

std::string DepthStream::start()
{
  return stream_.start() == openni::STATUS_OK ? std::string()
                                              : failure(uri_ + " does not start its depth stream");
}

void DepthStream::stop()
{
  frame_.release();
  stream_.stop();
}

DepthStream::Read DepthStream::read(std::chrono::milliseconds timeout,
                                    const std::function<void(const DepthFrame&)>& on_frame)
{
  openni::VideoStream* streams[] = {&stream_};
  int ready = 0;
  const auto status = openni::OpenNI::waitForAnyStream(streams, 1, &ready, static_cast<int>(timeout.count()));
  if (status == openni::STATUS_TIME_OUT) return Read::kNothing;
  if (status != openni::STATUS_OK || stream_.readFrame(&frame_) != openni::STATUS_OK) return Read::kFailed;
  if (frame_.getVideoMode().getPixelFormat() != openni::PIXEL_FORMAT_DEPTH_1_MM) return Read::kFailed;
  const bool begun_again = isFile() && frame_.getFrameIndex() <= last_index_;
  last_index_ = frame_.getFrameIndex();
  if (begun_again && !loop_) return Read::kEnd;
  DepthFrame frame;
  frame.data = static_cast<const std::uint8_t*>(frame_.getData());
  frame.step = static_cast<std::size_t>(frame_.getStrideInBytes());
  frame.width = static_cast<std::uint32_t>(frame_.getWidth());
  frame.height = static_cast<std::uint32_t>(frame_.getHeight());
  frame.timestamp = frame_.getTimestamp();
  frame.serial = serial_;
  setIntrinsics(frame);
  on_frame(frame);
  frame_.release();
  return Read::kFrame;
}

void DepthStream::setIntrinsics(DepthFrame& frame) const
{
  const openni::VideoStream& seen_by = color_.isValid() ? color_ : stream_;
  frame.focal_length = 0.5 * frame.width / std::tan(0.5 * seen_by.getHorizontalFieldOfView());
  if (registered_) return;
  const double scale = frame.width / 640.0;
  frame.offset_x = (stream_.getMirroringEnabled() ? 1.0 : -1.0) * kCorrelationOffsetX * scale;
  frame.offset_y = -kCorrelationOffsetY * scale;
}

}  // namespace polygonal_perception::openni2

#include "virtual_stream.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <memory>

namespace polygonal_perception::virtual_device {
namespace {

constexpr int kMaxDepth = 10000;  // [mm] as PrimeSense's devices report

template <class T>
OniStatus put(const T& value, void* data, int* size)
{
  if (*size < static_cast<int>(sizeof value)) return ONI_STATUS_BAD_PARAMETER;
  *size = sizeof value;
  std::memcpy(data, &value, sizeof value);
  return ONI_STATUS_OK;
}

template <class T>
OniStatus take(T& value, const void* data, int size)
{
  if (size != static_cast<int>(sizeof value)) return ONI_STATUS_BAD_PARAMETER;
  std::memcpy(&value, data, sizeof value);
  return ONI_STATUS_OK;
}

float fieldOfView(int pixels, double focal_length)
{
  return static_cast<float>(2.0 * std::atan(0.5 * pixels / focal_length));
}

OniPixelFormat formatOf(OniSensorType sensor)
{
  if (sensor == ONI_SENSOR_DEPTH) return ONI_PIXEL_FORMAT_DEPTH_1_MM;
  return sensor == ONI_SENSOR_COLOR ? ONI_PIXEL_FORMAT_RGB888 : ONI_PIXEL_FORMAT_GRAY16;
}

int bytesPerPixel(const OniVideoMode& mode)
{
  return mode.pixelFormat == ONI_PIXEL_FORMAT_RGB888 ? static_cast<int>(sizeof(OniRGB888Pixel)) : 2;
}

int bytesPerFrame(const OniVideoMode& mode)
{
  return mode.resolutionX * mode.resolutionY * bytesPerPixel(mode);
}

bool isSame(const OniVideoMode& a, const OniVideoMode& b)
{
  return a.pixelFormat == b.pixelFormat && a.resolutionX == b.resolutionX && a.resolutionY == b.resolutionY &&
         a.fps == b.fps;
}

simulation::SimulatedCamera::Options cameraOptions(View view, const OniVideoMode& mode)
{
  return cameraOptions(view, Mode{mode.resolutionX, mode.resolutionY, mode.fps});
}

/// Writes pixels row by row, mirrored where asked.
template <class Pixel, class Convert>
void write(const std::vector<std::uint16_t>& millimetres, int width, bool mirror, void* data,
           Convert&& convert)
{
  auto* row = static_cast<Pixel*>(data);
  for (auto from = millimetres.begin(); from != millimetres.end(); from += width, row += width) {
    std::transform(from, from + width, row, convert);
    if (mirror) std::reverse(row, row + width);
  }
}

}  // namespace

std::vector<OniVideoMode> VirtualStream::modes(OniSensorType sensor)
{
  std::vector<OniVideoMode> modes;
  for (const Mode& mode : kModes) modes.push_back({formatOf(sensor), mode.width, mode.height, mode.rate});
  return modes;
}

VirtualStream::VirtualStream(OniSensorType sensor, DeviceState& device)
    : sensor_(sensor), device_(device), mode_(modes(sensor).front())
{
}

VirtualStream::~VirtualStream()
{
  stop();
}

View VirtualStream::view() const
{
  if (sensor_ == ONI_SENSOR_IR) return View::kInfrared;
  return sensor_ == ONI_SENSOR_COLOR || device_.registers ? View::kColor : View::kDepth;
}

OniVideoMode VirtualStream::mode()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return mode_;
}

bool VirtualStream::mirrors()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return mirror_ == TRUE;
}

OniStatus VirtualStream::setProperty(int id, const void* data, int size)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (id == ONI_STREAM_PROPERTY_MIRRORING) return take(mirror_, data, size);
  if (id != ONI_STREAM_PROPERTY_VIDEO_MODE) return ONI_STATUS_NOT_SUPPORTED;
  OniVideoMode asked{};
  const OniStatus status = take(asked, data, size);
  if (status != ONI_STATUS_OK) return status;
  const std::vector<OniVideoMode> known = modes(sensor_);
  if (std::none_of(known.begin(), known.end(), [&](const OniVideoMode& mode) { return isSame(mode, asked); }))
    return ONI_STATUS_NOT_SUPPORTED;
  mode_ = asked;
  return ONI_STATUS_OK;
}

OniStatus VirtualStream::getProperty(int id, void* data, int* size)
{
  const OniVideoMode mode = this->mode();
  // The field of view is the sensor's own, also of depth that is registered.
  const auto camera = pinhole(sensor_ == ONI_SENSOR_COLOR ? View::kColor : View::kInfrared, mode.resolutionX,
                              mode.resolutionY);
  switch (id) {
    // A recording plays only with these two in it.
    case ONI_STREAM_PROPERTY_CROPPING:
      return put(OniCropping{}, data, size);
    case ONI_STREAM_PROPERTY_STRIDE:
      return put(mode.resolutionX * bytesPerPixel(mode), data, size);
    case ONI_STREAM_PROPERTY_VIDEO_MODE:
      return put(mode, data, size);
    case ONI_STREAM_PROPERTY_MIRRORING:
      return put(mirrors() ? TRUE : FALSE, data, size);
    case ONI_STREAM_PROPERTY_HORIZONTAL_FOV:
      return put(fieldOfView(mode.resolutionX, camera.fx), data, size);
    case ONI_STREAM_PROPERTY_VERTICAL_FOV:
      return put(fieldOfView(mode.resolutionY, camera.fy), data, size);
    case ONI_STREAM_PROPERTY_MAX_VALUE:
      return sensor_ == ONI_SENSOR_DEPTH ? put(kMaxDepth, data, size) : ONI_STATUS_NOT_SUPPORTED;
    case ONI_STREAM_PROPERTY_MIN_VALUE:
      return sensor_ == ONI_SENSOR_DEPTH ? put(0, data, size) : ONI_STATUS_NOT_SUPPORTED;
    default:
      return ONI_STATUS_NOT_SUPPORTED;
  }
}

OniBool VirtualStream::isPropertySupported(int id)
{
  char value[sizeof(OniCropping)];  // the largest of all
  int size = sizeof value;
  return getProperty(id, value, &size) == ONI_STATUS_OK ? TRUE : FALSE;
}

void VirtualStream::notifyAllProperties()
{
  for (int id = ONI_STREAM_PROPERTY_CROPPING; id <= ONI_STREAM_PROPERTY_MIRRORING; ++id) {
    char value[sizeof(OniCropping)];  // the largest of all
    int size = sizeof value;
    if (getProperty(id, value, &size) == ONI_STATUS_OK) raisePropertyChanged(id, value, size);
  }
}

int VirtualStream::getRequiredFrameSize()
{
  // OpenNI asks once a start, and the mode may become another while the stream runs.
  int size = 0;
  for (const OniVideoMode& mode : modes(sensor_)) size = std::max(size, bytesPerFrame(mode));
  return size;
}

OniStatus VirtualStream::start()
{
  if (!device_.isPlugged()) return ONI_STATUS_NO_DEVICE;
  running_ = true;
  thread_ = std::thread([this] { run(); });
  return ONI_STATUS_OK;
}

void VirtualStream::stop()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    running_ = false;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void VirtualStream::run()
{
  std::unique_ptr<simulation::SimulatedCamera> camera;
  OniVideoMode mode{};
  View view{};
  simulation::SimulatedFrame frame;
  std::vector<std::uint16_t> millimetres;
  std::uint32_t index = 0;
  DeviceState::Clock::time_point due;
  for (;; ++index) {
    if (!camera || !isSame(mode, this->mode()) || view != this->view()) {
      mode = this->mode();
      view = this->view();
      camera = std::make_unique<simulation::SimulatedCamera>(cameraOptions(view, mode));
      millimetres.resize(camera->options().camera.size());
      const auto epoch = device_.epoch();
      const std::chrono::duration<double> now = DeviceState::Clock::now() - epoch;
      index = static_cast<std::uint32_t>(std::ceil(now.count() * mode.fps));
      due = epoch + std::chrono::microseconds(timestampOf(index, mode.fps));
    }
    camera->render(index, frame);
    simulation::toMillimetres(frame.depth, millimetres.data());
    due = std::max(due, DeviceState::Clock::now());
    std::unique_lock<std::mutex> lock(mutex_);
    if (changed_.wait_until(lock, due, [this] { return !running_; })) return;
    lock.unlock();
    if (device_.isPlugged()) send(millimetres, mode, index);
    due += std::chrono::microseconds(timestampOf(1, mode.fps));
  }
}

void VirtualStream::send(const std::vector<std::uint16_t>& millimetres, const OniVideoMode& mode,
                         std::uint32_t index)
{
  OniFrame* frame = getServices().acquireFrame();
  if (frame == nullptr) return;
  frame->sensorType = sensor_;
  frame->timestamp = timestampOf(index, mode.fps);
  frame->frameIndex = static_cast<int>(index);
  frame->videoMode = mode;
  frame->width = mode.resolutionX;
  frame->height = mode.resolutionY;
  frame->croppingEnabled = FALSE;
  frame->cropOriginX = 0;
  frame->cropOriginY = 0;
  frame->stride = frame->width * bytesPerPixel(mode);
  frame->dataSize = frame->stride * frame->height;
  const bool mirror = mirrors();
  if (sensor_ == ONI_SENSOR_COLOR) {
    write<OniRGB888Pixel>(millimetres, frame->width, mirror, frame->data, [](std::uint16_t depth) {
      const auto grey =
          static_cast<std::uint8_t>(std::min(depth, std::uint16_t{kMaxDepth}) * 255 / kMaxDepth);
      return OniRGB888Pixel{grey, grey, grey};
    });
  } else {
    write<std::uint16_t>(millimetres, frame->width, mirror, frame->data,
                         [](std::uint16_t depth) { return depth; });
  }
  raiseNewFrame(frame);
  getServices().releaseFrame(frame);
}

}  // namespace polygonal_perception::virtual_device

#include "virtual_stream.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <iterator>
#include <vector>

#include "virtual_camera.hpp"

namespace polygonal_perception {
namespace virtual_device {
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

float fieldOfView(int pixels, double focal_length)
{
  return static_cast<float>(2.0 * std::atan(0.5 * pixels / focal_length));
}

}  // namespace

OniSensorInfo& VirtualStream::sensorInfo()
{
  static OniVideoMode modes[] = {
      {ONI_PIXEL_FORMAT_DEPTH_1_MM, kModes[0][0], kModes[0][1], kRate},
      {ONI_PIXEL_FORMAT_DEPTH_1_MM, kModes[1][0], kModes[1][1], kRate},
  };
  static OniSensorInfo info = {ONI_SENSOR_DEPTH, static_cast<int>(std::size(modes)), modes};
  return info;
}

VirtualStream::VirtualStream(const std::atomic<bool>& plugged)
    : plugged_(plugged), mode_(sensorInfo().pSupportedVideoModes[0])
{
}

VirtualStream::~VirtualStream()
{
  stop();
}

OniStatus VirtualStream::setProperty(int id, const void* data, int size)
{
  if (id == ONI_STREAM_PROPERTY_VIDEO_MODE && size == sizeof mode_) {
    std::memcpy(&mode_, data, sizeof mode_);
    return ONI_STATUS_OK;
  }
  if (id == ONI_STREAM_PROPERTY_MIRRORING && size == sizeof mirror_) {
    std::memcpy(&mirror_, data, sizeof mirror_);
    return ONI_STATUS_OK;
  }
  return ONI_STATUS_NOT_SUPPORTED;
}

OniStatus VirtualStream::getProperty(int id, void* data, int* size)
{
  const auto camera = simulation::PinholeCamera::ofSize(static_cast<std::uint32_t>(mode_.resolutionX),
                                                        static_cast<std::uint32_t>(mode_.resolutionY));
  switch (id) {
    // A recording plays only with these two in it.
    case ONI_STREAM_PROPERTY_CROPPING:
      return put(OniCropping{}, data, size);
    case ONI_STREAM_PROPERTY_STRIDE:
      return put(mode_.resolutionX * static_cast<int>(sizeof(OniDepthPixel)), data, size);
    case ONI_STREAM_PROPERTY_VIDEO_MODE:
      return put(mode_, data, size);
    case ONI_STREAM_PROPERTY_MIRRORING:
      return put(mirror_, data, size);
    case ONI_STREAM_PROPERTY_HORIZONTAL_FOV:
      return put(fieldOfView(mode_.resolutionX, camera.fx), data, size);
    case ONI_STREAM_PROPERTY_VERTICAL_FOV:
      return put(fieldOfView(mode_.resolutionY, camera.fy), data, size);
    case ONI_STREAM_PROPERTY_MAX_VALUE:
      return put(kMaxDepth, data, size);
    case ONI_STREAM_PROPERTY_MIN_VALUE:
      return put(0, data, size);
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
  return mode_.resolutionX * mode_.resolutionY * static_cast<int>(sizeof(OniDepthPixel));
}

OniStatus VirtualStream::start()
{
  if (!plugged_) return ONI_STATUS_NO_DEVICE;
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
  simulation::SimulatedCamera camera(cameraOptions(mode_.resolutionX, mode_.resolutionY));
  simulation::SimulatedFrame frame;
  std::vector<std::uint16_t> millimetres(camera.options().camera.size());
  auto due = std::chrono::steady_clock::now();
  for (std::uint32_t index = 0;; ++index) {
    camera.render(index, frame);
    simulation::toMillimetres(frame.depth, millimetres.data());
    due = std::max(due, std::chrono::steady_clock::now());
    std::unique_lock<std::mutex> lock(mutex_);
    if (changed_.wait_until(lock, due, [this] { return !running_; })) return;
    lock.unlock();
    if (plugged_) send(millimetres.data(), index);
    due += std::chrono::microseconds(timestampOf(1));
  }
}

void VirtualStream::send(const std::uint16_t* millimetres, std::uint32_t index)
{
  OniFrame* frame = getServices().acquireFrame();
  if (frame == nullptr) return;
  frame->sensorType = ONI_SENSOR_DEPTH;
  frame->timestamp = timestampOf(index);
  frame->frameIndex = static_cast<int>(index);
  frame->videoMode = mode_;
  frame->width = mode_.resolutionX;
  frame->height = mode_.resolutionY;
  frame->croppingEnabled = FALSE;
  frame->cropOriginX = 0;
  frame->cropOriginY = 0;
  frame->stride = frame->width * static_cast<int>(sizeof(OniDepthPixel));
  frame->dataSize = frame->stride * frame->height;
  std::memcpy(frame->data, millimetres, static_cast<std::size_t>(frame->dataSize));
  if (mirror_ == TRUE) {
    auto* pixels = static_cast<OniDepthPixel*>(frame->data);
    for (int row = 0; row < frame->height; ++row, pixels += frame->width)
      std::reverse(pixels, pixels + frame->width);
  }
  raiseNewFrame(frame);
  getServices().releaseFrame(frame);
}

}  // namespace virtual_device
}  // namespace polygonal_perception

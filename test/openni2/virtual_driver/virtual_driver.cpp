// A driver for OpenNI2 with one device, which plays rendered scenes and can be unplugged.
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <mutex>
#include <new>
#include <thread>
#include <utility>
#include <vector>

#include "virtual_camera.hpp"
#include "virtual_stream.hpp"

// The driver API's export macro leaves these to the driver.
#define XN_NEW(Type, argument) new Type(argument)
#define XN_DELETE(pointer) delete (pointer)

namespace polygonal_perception::virtual_device {

/// How long a device is away at least when its plug is pulled and put in again. That of a USB device is, too:
/// openni2_camera, which looks once a second, relies on it.
constexpr std::chrono::milliseconds kEnumeration{1500};

/// A sensor's modes, in the form in which a driver tells them.
class Sensor
{
public:
  explicit Sensor(OniSensorType type) : type_(type), modes_(VirtualStream::modes(type)) {}
  OniSensorInfo info() { return {type_, static_cast<int>(modes_.size()), modes_.data()}; }

private:
  OniSensorType type_;
  std::vector<OniVideoMode> modes_;
};

class VirtualDevice : public oni::driver::DeviceBase
{
public:
  explicit VirtualDevice(std::shared_ptr<const std::atomic<bool>> plugged) : state_(std::move(plugged))
  {
    sensors_.emplace_back(ONI_SENSOR_DEPTH);
    sensors_.emplace_back(ONI_SENSOR_IR);
    if (has_color_) sensors_.emplace_back(ONI_SENSOR_COLOR);
    for (Sensor& sensor : sensors_) infos_.push_back(sensor.info());
  }

  OniStatus getSensorInfoList(OniSensorInfo** infos, int* count) override
  {
    *infos = infos_.data();
    *count = static_cast<int>(infos_.size());
    return ONI_STATUS_OK;
  }
  oni::driver::StreamBase* createStream(OniSensorType type) override
  {
    return new VirtualStream(type, state_);
  }
  void destroyStream(oni::driver::StreamBase* stream) override { delete stream; }

  OniStatus getProperty(int id, void* data, int* size) override
  {
    if (id == ONI_DEVICE_PROPERTY_SERIAL_NUMBER) {
      const int length = static_cast<int>(std::strlen(kSerialNumber)) + 1;
      if (*size < length) return ONI_STATUS_BAD_PARAMETER;
      std::memcpy(data, kSerialNumber, static_cast<std::size_t>(length));
      *size = length;
      return ONI_STATUS_OK;
    }
    if (id != ONI_DEVICE_PROPERTY_IMAGE_REGISTRATION) return ONI_STATUS_NOT_SUPPORTED;
    const auto mode = state_.registers ? ONI_IMAGE_REGISTRATION_DEPTH_TO_COLOR : ONI_IMAGE_REGISTRATION_OFF;
    if (*size != static_cast<int>(sizeof mode)) return ONI_STATUS_BAD_PARAMETER;
    std::memcpy(data, &mode, sizeof mode);
    return ONI_STATUS_OK;
  }
  OniStatus setProperty(int id, const void* data, int size) override
  {
    OniImageRegistrationMode mode{};
    if (id != ONI_DEVICE_PROPERTY_IMAGE_REGISTRATION) return ONI_STATUS_NOT_SUPPORTED;
    if (size != static_cast<int>(sizeof mode)) return ONI_STATUS_BAD_PARAMETER;
    std::memcpy(&mode, data, sizeof mode);
    if (isImageRegistrationModeSupported(mode) != TRUE) return ONI_STATUS_NOT_SUPPORTED;
    state_.registers = mode == ONI_IMAGE_REGISTRATION_DEPTH_TO_COLOR;
    return ONI_STATUS_OK;
  }
  OniBool isImageRegistrationModeSupported(OniImageRegistrationMode mode) override
  {
    return mode == ONI_IMAGE_REGISTRATION_OFF || has_color_ ? TRUE : FALSE;
  }

private:
  const bool has_color_ = std::getenv(kColorless) == nullptr;
  DeviceState state_;
  std::vector<Sensor> sensors_;
  std::vector<OniSensorInfo> infos_;
};

class VirtualDriver : public oni::driver::DriverBase
{
public:
  explicit VirtualDriver(OniDriverServices* services) : DriverBase(services), info_{}
  {
    std::snprintf(info_.uri, sizeof info_.uri, "%s", kUri);
    std::snprintf(info_.vendor, sizeof info_.vendor, "%s", kVendor);
    std::snprintf(info_.name, sizeof info_.name, "%s", kName);
  }
  ~VirtualDriver() override { shutdown(); }

  OniStatus initialize(oni::driver::DeviceConnectedCallback connected,
                       oni::driver::DeviceDisconnectedCallback disconnected,
                       oni::driver::DeviceStateChangedCallback state_changed, void* cookie) override
  {
    const OniStatus status = DriverBase::initialize(connected, disconnected, state_changed, cookie);
    if (status != ONI_STATUS_OK) return status;
    if (isPlugIn()) connect();
    watcher_ = std::thread([this] { watch(); });
    return ONI_STATUS_OK;
  }
  oni::driver::DeviceBase* deviceOpen(const char* /*uri*/, const char* /*mode*/) override
  {
    const std::lock_guard<std::mutex> lock(plug_mutex_);
    return *plugged_ ? new VirtualDevice(plugged_) : nullptr;
  }
  void deviceClose(oni::driver::DeviceBase* device) override { delete device; }
  OniStatus tryDevice(const char* /*uri*/) override { return ONI_STATUS_NOT_SUPPORTED; }
  void shutdown() override
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      ending_ = true;
    }
    changed_.notify_all();
    if (watcher_.joinable()) watcher_.join();
  }

private:
  static bool isPlugIn()
  {
    const char* plug = std::getenv(kPlug);
    return plug == nullptr || std::filesystem::exists(plug);
  }
  void connect()
  {
    {
      const std::lock_guard<std::mutex> lock(plug_mutex_);
      plugged_ = std::make_shared<std::atomic<bool>>(true);  // what was opened before stays dead
    }
    deviceConnected(&info_);
  }
  /// Tells OpenNI when the plug has been put in or pulled.
  void follow()
  {
    const auto now = std::chrono::steady_clock::now();
    if (!isPlugIn()) {
      out_ = now;
      if (plugged_->exchange(false)) deviceDisconnected(&info_);
    } else if (!*plugged_ && now - out_ > kEnumeration) {
      connect();
    }
  }
  void watch()
  {
    // Not inside the mutex: OpenNI's own, which follow() takes, is locked when shutdown() is called.
    while (!endsSoon()) follow();
  }
  bool endsSoon()
  {
    std::unique_lock<std::mutex> lock(mutex_);
    return changed_.wait_for(lock, std::chrono::milliseconds(20), [this] { return ending_; });
  }

  OniDeviceInfo info_;
  std::chrono::steady_clock::time_point out_;  // when the plug was out for the last time
  std::mutex plug_mutex_;  // of which plugged_ it is, in the watcher and where a device is opened
  std::shared_ptr<std::atomic<bool>> plugged_ = std::make_shared<std::atomic<bool>>(false);
  std::mutex mutex_;
  std::condition_variable changed_;
  bool ending_ = false;
  std::thread watcher_;
};

}  // namespace polygonal_perception::virtual_device

ONI_EXPORT_DRIVER(polygonal_perception::virtual_device::VirtualDriver)

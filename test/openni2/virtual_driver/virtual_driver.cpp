// A driver for OpenNI2 with one device, which plays rendered scenes and can be unplugged.
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <new>
#include <thread>

#include "virtual_camera.hpp"
#include "virtual_stream.hpp"

// The driver API's export macro leaves these to the driver.
#define XN_NEW(Type, argument) new Type(argument)
#define XN_DELETE(pointer) delete (pointer)

namespace polygonal_perception {
namespace virtual_device {

class VirtualDevice : public oni::driver::DeviceBase
{
public:
  explicit VirtualDevice(const std::atomic<bool>& plugged) : plugged_(plugged) {}

  OniStatus getSensorInfoList(OniSensorInfo** infos, int* count) override
  {
    *infos = &VirtualStream::sensorInfo();
    *count = 1;
    return ONI_STATUS_OK;
  }
  oni::driver::StreamBase* createStream(OniSensorType type) override
  {
    return type == ONI_SENSOR_DEPTH ? new VirtualStream(plugged_) : nullptr;
  }
  void destroyStream(oni::driver::StreamBase* stream) override { delete stream; }

  OniStatus getProperty(int id, void* data, int* size) override
  {
    const int length = static_cast<int>(std::strlen(kSerialNumber)) + 1;
    if (id != ONI_DEVICE_PROPERTY_SERIAL_NUMBER || *size < length) return ONI_STATUS_NOT_SUPPORTED;
    std::memcpy(data, kSerialNumber, static_cast<std::size_t>(length));
    *size = length;
    return ONI_STATUS_OK;
  }
  OniBool isImageRegistrationModeSupported(OniImageRegistrationMode mode) override
  {
    return mode == ONI_IMAGE_REGISTRATION_OFF || std::getenv(kRegisters) != nullptr ? TRUE : FALSE;
  }
  OniStatus setProperty(int id, const void* /*data*/, int /*size*/) override
  {
    return id == ONI_DEVICE_PROPERTY_IMAGE_REGISTRATION ? ONI_STATUS_OK : ONI_STATUS_NOT_SUPPORTED;
  }

private:
  const std::atomic<bool>& plugged_;
};

class VirtualDriver : public oni::driver::DriverBase
{
public:
  explicit VirtualDriver(OniDriverServices* services) : DriverBase(services), info_{}
  {
    std::snprintf(info_.uri, sizeof info_.uri, "%s", kUri);
    std::snprintf(info_.vendor, sizeof info_.vendor, "polygonal_perception");
    std::snprintf(info_.name, sizeof info_.name, "virtual camera");
  }
  ~VirtualDriver() override { shutdown(); }

  OniStatus initialize(oni::driver::DeviceConnectedCallback connected,
                       oni::driver::DeviceDisconnectedCallback disconnected,
                       oni::driver::DeviceStateChangedCallback state_changed, void* cookie) override
  {
    const OniStatus status = DriverBase::initialize(connected, disconnected, state_changed, cookie);
    if (status != ONI_STATUS_OK) return status;
    follow();
    watcher_ = std::thread([this] { watch(); });
    return ONI_STATUS_OK;
  }
  oni::driver::DeviceBase* deviceOpen(const char* /*uri*/, const char* /*mode*/) override
  {
    return plugged_ ? new VirtualDevice(plugged_) : nullptr;
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
  /// Tells OpenNI when the plug has been put in or pulled.
  void follow()
  {
    const char* plug = std::getenv(kPlug);
    const bool plugged = plug == nullptr || std::filesystem::exists(plug);
    if (plugged == plugged_) return;
    plugged_ = plugged;
    if (plugged) {
      deviceConnected(&info_);
    } else {
      deviceDisconnected(&info_);
    }
  }
  void watch()
  {
    std::unique_lock<std::mutex> lock(mutex_);
    while (!changed_.wait_for(lock, std::chrono::milliseconds(20), [this] { return ending_; })) follow();
  }

  OniDeviceInfo info_;
  std::atomic<bool> plugged_{false};
  std::mutex mutex_;
  std::condition_variable changed_;
  bool ending_ = false;
  std::thread watcher_;
};

}  // namespace virtual_device
}  // namespace polygonal_perception

ONI_EXPORT_DRIVER(polygonal_perception::virtual_device::VirtualDriver)

#pragma once

#include <Driver/OniDriverAPI.h>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace polygonal_perception {
namespace virtual_device {

/// A depth stream that plays the simulated camera's frames from the first at each start, none left out: it
/// falls behind where the machine is too slow.
class VirtualStream : public oni::driver::StreamBase
{
public:
  /// @param plugged  no more frames once it is false
  explicit VirtualStream(const std::atomic<bool>& plugged);
  ~VirtualStream() override;

  OniStatus setProperty(int id, const void* data, int size) override;
  OniStatus getProperty(int id, void* data, int* size) override;
  OniBool isPropertySupported(int id) override;
  void notifyAllProperties() override;
  int getRequiredFrameSize() override;
  OniStatus start() override;
  void stop() override;

  /// The modes on offer.
  static OniSensorInfo& sensorInfo();

private:
  void run();
  void send(const std::uint16_t* millimetres, std::uint32_t index);

  const std::atomic<bool>& plugged_;
  OniVideoMode mode_;
  OniBool mirror_ = TRUE;  // as PrimeSense's devices start
  std::mutex mutex_;
  std::condition_variable changed_;
  bool running_ = false;
  std::thread thread_;
};

}  // namespace virtual_device
}  // namespace polygonal_perception

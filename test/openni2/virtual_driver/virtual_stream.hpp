#pragma once

#include <Driver/OniDriverAPI.h>

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

#include "device_state.hpp"
#include "virtual_camera.hpp"

namespace polygonal_perception::virtual_device {

/// A stream of depth, or of grey pictures of it for the other two sensors, that plays the simulated camera's
/// frames as the device's clock has it. While it runs none is left out: it falls behind where the machine is
/// too slow. Its mode may be changed while it runs.
class VirtualStream : public oni::driver::StreamBase
{
public:
  VirtualStream(OniSensorType sensor, DeviceState& device);
  ~VirtualStream() override;

  OniStatus setProperty(int id, const void* data, int size) override;
  OniStatus getProperty(int id, void* data, int* size) override;
  OniBool isPropertySupported(int id) override;
  void notifyAllProperties() override;
  int getRequiredFrameSize() override;
  OniStatus start() override;
  void stop() override;

  /// A sensor's modes.
  static std::vector<OniVideoMode> modes(OniSensorType sensor);

private:
  void run();
  void send(const std::vector<std::uint16_t>& millimetres, const OniVideoMode& mode, std::uint32_t index);
  View view() const;
  OniVideoMode mode();
  bool mirrors();

  const OniSensorType sensor_;
  DeviceState& device_;
  std::mutex mutex_;  // of what follows
  std::condition_variable changed_;
  OniVideoMode mode_;
  OniBool mirror_ = TRUE;  // as PrimeSense's devices start
  bool running_ = false;
  std::thread thread_;
};

}  // namespace polygonal_perception::virtual_device

#pragma once

#include "polygonal_perception/simulation/simulated_camera.hpp"

/// What the virtual device sees and how it is called: its driver and the tests share this.
namespace polygonal_perception {
namespace virtual_device {

constexpr const char* kUri = "virtual@1/1";
constexpr const char* kSerialNumber = "VIRTUAL0001";
/// Environment: if set, the device says that it registers depth to colour; its two cameras see the same.
constexpr const char* kRegisters = "POLYGONAL_PERCEPTION_VIRTUAL_REGISTERS";
/// Environment: the device is plugged in while the file of that name exists; if unset, always.
constexpr const char* kPlug = "POLYGONAL_PERCEPTION_VIRTUAL_PLUG";

/// The modes: width and height at 30 Hz.
constexpr int kModes[][2] = {{320, 240}, {640, 480}};
constexpr int kRate = 30;  // [Hz]

/// Frame i of a stream is this camera's frame i, with the stamp timestampOf(i).
inline simulation::SimulatedCamera::Options cameraOptions(int width, int height)
{
  simulation::SimulatedCamera::Options options;
  options.scene = "office";
  options.trajectory = "robotino";
  options.seed = 4;
  options.rate = kRate;
  options.camera = simulation::PinholeCamera::ofSize(static_cast<std::uint32_t>(width),
                                                     static_cast<std::uint32_t>(height));
  return options;
}

/// [us]
inline std::uint64_t timestampOf(std::uint32_t index)
{
  return std::uint64_t{1000000} * index / kRate;
}

}  // namespace virtual_device
}  // namespace polygonal_perception

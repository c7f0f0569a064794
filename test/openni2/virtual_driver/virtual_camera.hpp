#pragma once

#include "polygonal_perception/cameras/simulation/simulated_camera.hpp"

/// What the virtual device sees and how it is called: its driver and the tests share this. It is made like an
/// ASUS Xtion Pro Live, and answers all that openni2_camera asks of such a device.
namespace polygonal_perception::virtual_device {

constexpr const char* kUri = "virtual@1/1";
constexpr const char* kVendor = "polygonal_perception";
constexpr const char* kName = "VirtualXtion";
constexpr const char* kSerialNumber = "VIRTUAL0001";
/// Environment: if set, the device has no colour camera, and so registers nothing, as an ASUS Xtion Pro.
constexpr const char* kColorless = "POLYGONAL_PERCEPTION_VIRTUAL_COLORLESS";
/// Environment: the device is plugged in while the file of that name exists; if unset, always.
constexpr const char* kPlug = "POLYGONAL_PERCEPTION_VIRTUAL_PLUG";

struct Mode
{
  int width;   ///< [px]
  int height;  ///< [px]
  int rate;    ///< [Hz]
};
/// Those of openni2_camera that are not too large for depth (its numbers 8, 5 to 7, 9 to 12), for each
/// sensor; the first is that of a new stream.
constexpr Mode kModes[] = {{320, 240, 30}, {640, 480, 30}, {640, 480, 25}, {320, 240, 25},
                           {320, 240, 60}, {160, 120, 25}, {160, 120, 30}, {160, 120, 60}};

/// The lens through which a picture is taken. They are all at one place.
enum class View
{
  kInfrared,
  kDepth,  ///< the infrared one, its picture moved by half of the window in which the sensor correlates
  kColor   ///< registered depth is as seen from here
};

inline simulation::PinholeCamera pinhole(View view, int width, int height)
{
  auto camera = simulation::PinholeCamera::ofSize(static_cast<std::uint32_t>(width),
                                                  static_cast<std::uint32_t>(height));
  const double scale = width / 640.0;
  if (view == View::kDepth) {
    // http://wiki.ros.org/kinect_calibration/technical, as openni2_camera has it (depth_ir_offset_x and _y)
    camera.cx -= 5.0 * scale;
    camera.cy -= 4.0 * scale;
  }
  if (view == View::kColor) camera.fx = camera.fy = 525.0 * scale;
  return camera;
}

/// Frame i of a stream is this camera's frame i, with the stamp timestampOf(i).
inline simulation::SimulatedCamera::Options cameraOptions(View view, const Mode& mode)
{
  simulation::SimulatedCamera::Options options;
  options.scene = "office";
  options.trajectory = "robotino";
  options.seed = 4;
  options.rate = mode.rate;
  options.camera = pinhole(view, mode.width, mode.height);
  return options;
}

/// [us] since the first start of one of the device's streams: its clock goes on while none runs.
inline std::uint64_t timestampOf(std::uint32_t index, int rate)
{
  return std::uint64_t{1000000} * index / static_cast<std::uint64_t>(rate);
}

}  // namespace polygonal_perception::virtual_device

#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "virtual_driver/virtual_camera.hpp"

namespace polygonal_perception::virtual_device {

/// The frames that the virtual device plays, rendered once more.
class RenderedFrames
{
public:
  explicit RenderedFrames(const Mode& mode, View view = View::kDepth) : camera_(cameraOptions(view, mode)) {}

  const simulation::SimulatedFrame& frame(std::uint32_t index)
  {
    camera_.render(index, frame_);
    return frame_;
  }
  /// [mm] row by row
  std::vector<std::uint16_t> depth(std::uint32_t index)
  {
    std::vector<std::uint16_t> millimetres(camera_.options().camera.size());
    simulation::toMillimetres(frame(index).depth, millimetres.data());
    return millimetres;
  }
  const simulation::SimulatedCamera& camera() const { return camera_; }

private:
  simulation::SimulatedCamera camera_;
  simulation::SimulatedFrame frame_;
};

/// The frame whose stamp is that many microseconds after frame 0's.
inline std::uint32_t indexOf(std::uint64_t timestamp, int rate = 30)
{
  return static_cast<std::uint32_t>(std::llround(1e-6 * static_cast<double>(timestamp) * rate));
}

}  // namespace polygonal_perception::virtual_device

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "polygonal_perception/cameras/simulation/simulated_camera.hpp"
#include "polygonal_perception/perception/pipeline.hpp"

namespace polygonal_perception::reference {

/// A camera that stands still before a scene in which nothing moves: its frames differ by the sensor's noise
/// alone.
class StillView
{
public:
  /// Where a robot's drive through the scene begins.
  StillView(const std::string& scene, std::uint64_t seed);

  /// @param index  each has noise of its own
  /// @return a frame that lives until the next is asked for
  perception::Frame frame(std::uint32_t index);
  /// The frame without noise.
  perception::Frame ideal() const;

private:
  perception::Frame frameOf(const std::vector<float>& depth, double stamp) const;

  simulation::PinholeCamera camera_;
  perception::PinholeRays rays_;
  simulation::RayImage truth_;
  simulation::DepthNoise noise_;
  std::vector<float> depth_;
};

}  // namespace polygonal_perception::reference

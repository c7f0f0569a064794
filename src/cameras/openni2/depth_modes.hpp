#pragma once

#include "polygonal_perception/cameras/openni2/openni2_source.hpp"

namespace polygonal_perception::openni2 {

inline constexpr int kDepthModeCount = 12;

/// Sets size and rate by the number that openni2_camera has for a mode (its parameter depth_mode).
/// @return false, and nothing is changed, where there is no mode of that number
inline bool setDepthMode(int number, SourceOptions& options)
{
  struct Mode
  {
    int width, height, rate;
  };
  constexpr Mode kModes[kDepthModeCount] = {
      {1280, 1024, 30}, {1280, 1024, 15}, {1280, 720, 30}, {1280, 720, 15}, {640, 480, 30}, {640, 480, 25},
      {320, 240, 25},   {320, 240, 30},   {320, 240, 60},  {160, 120, 25},  {160, 120, 30}, {160, 120, 60}};
  if (number < 1 || number > kDepthModeCount) return false;
  const Mode& mode = kModes[number - 1];
  options.width = mode.width;
  options.height = mode.height;
  options.rate = mode.rate;
  return true;
}

}  // namespace polygonal_perception::openni2

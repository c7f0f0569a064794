#pragma once

#include <cstdint>
#include <string>
#include <utility>

namespace polygonal_perception::ros_perception {

/// What is wrong with the size of a frame, or nothing. A surface normal takes two pixels each way; samples
/// count pixels in 16 bits.
inline std::string imageSizeError(std::uint32_t width, std::uint32_t height)
{
  constexpr std::uint32_t kSmallest = 2;
  constexpr std::uint32_t kLargest = 65535;
  for (const auto& [name, size] : {std::pair{"width", width}, std::pair{"height", height}}) {
    if (size < kSmallest || size > kLargest) {
      return std::string(name) + " is " + std::to_string(size) + ", accepted is " +
             std::to_string(kSmallest) + " to " + std::to_string(kLargest);
    }
  }
  return {};
}

}  // namespace polygonal_perception::ros_perception

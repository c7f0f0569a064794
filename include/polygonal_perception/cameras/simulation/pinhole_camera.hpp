#pragma once

#include <cstddef>
#include <cstdint>

namespace polygonal_perception::simulation {

/// A pinhole camera without distortion. The default focal length is what openni2_camera reports for an ASUS
/// Xtion's depth at VGA.
struct PinholeCamera
{
  std::uint32_t width = 640;   ///< [px]
  std::uint32_t height = 480;  ///< [px]
  double fx = 570.3;           ///< [px]
  double fy = 570.3;           ///< [px]
  double cx = 319.5;           ///< [px] pixel centres lie at integers
  double cy = 239.5;           ///< [px]

  std::size_t size() const { return static_cast<std::size_t>(width) * height; }

  /// The same field of view across on an image of another size.
  static PinholeCamera ofSize(std::uint32_t width, std::uint32_t height)
  {
    PinholeCamera camera;
    const double scale = static_cast<double>(width) / camera.width;
    camera.fx *= scale;
    camera.fy *= scale;
    camera.cx = 0.5 * (width - 1.0);
    camera.cy = 0.5 * (height - 1.0);
    camera.width = width;
    camera.height = height;
    return camera;
  }
};

}  // namespace polygonal_perception::simulation

#pragma once

#include <cstdint>
#include <vector>

#include "polygonal_perception/cameras/simulation/pinhole_camera.hpp"

namespace polygonal_perception::simulation {

// Where a structured-light sensor has no return, apart from what single surfaces do. Images are row by row; a
// mask's pixels are set to 1 and never back to 0. Disparities are in pixels of the image, 0 = no surface.

/// What the projector does not light because something nearer stands in its way. It is at the camera's right.
/// @param line  memory to use again
void markShadows(const PinholeCamera& camera, const std::vector<float>& disparity, std::vector<float>& line,
                 std::vector<std::uint8_t>& mask);

/// Both sides of every jump of disparity.
/// @param width  [px] on each side
void markEdges(const PinholeCamera& camera, const std::vector<float>& disparity, int width,
               std::vector<std::uint8_t>& mask);

/// Ragged spots at random places.
/// @param average     number of spots
/// @param radius      [px] drawn from a fifth of it to twice it
/// @param raggedness  a value a pixel, about -1..1, that pushes the rim in and out
void markBlobs(const PinholeCamera& camera, double average, double radius,
               const std::vector<float>& raggedness, std::uint64_t seed, std::vector<std::uint8_t>& mask);

/// The columns at the right end that the correlation window cannot fill.
void markDeadColumns(const PinholeCamera& camera, std::uint32_t columns, std::vector<std::uint8_t>& mask);

}  // namespace polygonal_perception::simulation

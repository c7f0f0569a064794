#pragma once

namespace polygonal_perception::evaluation {

/// Prints how far polygons move under the sensor's noise alone, and what is lost, over min_points_per_cell.
/// @param frames  of each view
void printSteadiness(int frames);

}  // namespace polygonal_perception::evaluation

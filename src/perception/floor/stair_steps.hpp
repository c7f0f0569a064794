#pragma once

#include <vector>

#include "perception/floor/floor_selection.hpp"

namespace polygonal_perception::perception {

/// Marks the steps of staircases that lead down. A step may lie at a height that the camera can have, but the next one
/// below it, by the same rise, does not, and the next one above it is a plane too. Each lower one lies farther away:
/// what a shiny floor mirrors of something low that stands on it does not.
void markStairSteps(std::vector<FloorCandidate>& candidates, const FloorSelectionParameters& parameters);

}  // namespace polygonal_perception::perception

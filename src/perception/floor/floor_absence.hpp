#pragma once

#include "perception/planes/plane_extraction.hpp"
#include "polygonal_perception/perception/floor/floor_absence.hpp"
#include "polygonal_perception/perception/floor/floor_detector.hpp"

namespace polygonal_perception::perception {

/// Says why none of a frame's planes is the floor.
FloorAbsence explainAbsence(const PlaneExtraction& extraction, const FloorSelectionParameters& parameters,
                            const FloorPrior& prior);

}  // namespace polygonal_perception::perception

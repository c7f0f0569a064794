#pragma once

#include "polygonal_perception/perception/pipeline.hpp"

namespace polygonal_perception::test {

/// All that a frame can be asked for.
inline constexpr perception::Products kAllProducts{
    perception::Product::kPolygons,      perception::Product::kPlanes,
    perception::Product::kFloorHull,     perception::Product::kObstaclePoints,
    perception::Product::kLookedThrough, perception::Product::kScan};

/// Ends the program, as the fuzzer wants it, when `holds` is false.
void require(bool holds, const char* what);

/// What holds of the result of every frame, whatever it showed.
/// @param parameters  of the floor that the frame may have shown
void requireSound(const perception::Pipeline::Result& result,
                  const perception::FloorDetector::Parameters& parameters = {});

}  // namespace polygonal_perception::test

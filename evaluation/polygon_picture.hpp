#pragma once

#include <string>

namespace polygonal_perception::evaluation {

/// Draws cells, inflated cells and polygons of an office frame: the paper's on the left, this package's on
/// the right.
/// @throws std::runtime_error when the file cannot be written
void drawBeforeAndAfter(const std::string& file);

}  // namespace polygonal_perception::evaluation

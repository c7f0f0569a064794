#pragma once

#include <memory>

#include "paths/path_methods.hpp"

namespace polygonal_perception::evaluation {

/// navfn, move_base's own planner: Dijkstra's search over a grid, as NavfnROS calls it. That the grid is drawn counts as
/// preparation.
std::unique_ptr<PathMethod> navfnMethod(double resolution);

}  // namespace polygonal_perception::evaluation

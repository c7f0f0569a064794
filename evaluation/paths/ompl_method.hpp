#pragma once

#include <memory>

#include "paths/path_methods.hpp"

namespace polygonal_perception::evaluation {

enum class OmplPlanner
{
  kBitStar,     ///< gets better until its time is up
  kRrtConnect,  ///< ends with its first path, which is then simplified
};

/// OMPL's planners in a plane. Whether a place is free they ask this package's triangulation, and along a line every 2 cm.
/// @param seconds  that a query may take
std::unique_ptr<PathMethod> omplMethod(OmplPlanner planner, double seconds);

}  // namespace polygonal_perception::evaluation

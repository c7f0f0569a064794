#pragma once

#include <cstdint>
#include <string>

namespace polygonal_perception::reference {

/// What came of many plans.
struct PlanStress
{
  std::size_t sets = 0;
  std::size_t refused = 0;  ///< sets
  std::size_t valid = 0;    ///< sets, on which paths were held against the obstacles, too
  std::size_t queries = 0;
  std::size_t found = 0;  ///< paths
  double slowest = 0.0;   ///< [s] of a query
  std::string fault;      ///< what was wrong, with the seed of its set; empty where nothing was
};

/// Plans among broken obstacles (broken_obstacles.hpp) until a plan is not what it promises. The sides of one set are kept in
/// the next.
PlanStress stressPlans(std::uint32_t first_seed, std::size_t queries);

}  // namespace polygonal_perception::reference

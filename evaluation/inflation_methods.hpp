#pragma once

#include <memory>
#include <string>
#include <vector>

#include "polygonal_perception/occupancy/grid/binary_grid.hpp"

namespace polygonal_perception::evaluation {

/// A way to grow occupied cells by the robot's radius.
class InflationMethod
{
public:
  virtual ~InflationMethod() = default;
  virtual std::string name() const = 0;
  virtual void inflate(const occupancy::BinaryGrid& occupancy, occupancy::BinaryGrid& inflated) = 0;
};

/// This package, two others that give the same cells, and the paper's, which does not.
/// @param robot_radius  [m]
std::vector<std::unique_ptr<InflationMethod>> makeInflationMethods(double robot_radius, double resolution);

}  // namespace polygonal_perception::evaluation

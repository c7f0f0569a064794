#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "polygonal_perception/floor_tracker.hpp"
#include "polygonal_perception/plane.hpp"
#include "polygonal_perception/point_view.hpp"
#include "polygonal_perception/sample_grid.hpp"

namespace polygonal_perception {
namespace evaluation {

/// What a method says of a frame.
struct Answer
{
  FloorStatus status = FloorStatus::kNotFound;
  Plane plane;
};

/// A way to find the floor in a sequence of frames.
class FloorMethod
{
public:
  virtual ~FloorMethod() = default;
  virtual std::string name() const = 0;
  /// Forgets what it saw; starts from the initial up vector.
  virtual void reset() = 0;
  /// The camera is known to be no higher than this above its floor [m], where a method can make use of it.
  virtual void boundHeight(double highest) = 0;
  virtual Answer see(const PointView& points, const SampleGrid& grid, double stamp) = 0;
};

/// This package's, the paper's and, where it was built with PCL, a RANSAC for a plane that is perpendicular
/// to the up axis.
std::vector<std::unique_ptr<FloorMethod>> makeFloorMethods();

}  // namespace evaluation
}  // namespace polygonal_perception

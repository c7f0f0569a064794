#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "polygonal_perception/geometry/plane.hpp"
#include "polygonal_perception/perception/floor/floor_tracker.hpp"
#include "polygonal_perception/perception/input/point_view.hpp"
#include "polygonal_perception/perception/planes/sample_grid.hpp"

namespace polygonal_perception::evaluation {

/// What a method says of a frame.
struct Answer
{
  perception::FloorStatus status = perception::FloorStatus::kNotFound;
  geometry::Plane plane;
  /// Of the normal's three components and the distance, where a method tells.
  std::optional<Eigen::Matrix4d> covariance = std::nullopt;
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
  virtual Answer see(const perception::PointView& points, const perception::SampleGrid& grid,
                     double stamp) = 0;
};

/// This package's, the paper's and, where it was built with PCL, a RANSAC for a plane that is perpendicular
/// to the up axis.
std::vector<std::unique_ptr<FloorMethod>> makeFloorMethods();

}  // namespace polygonal_perception::evaluation

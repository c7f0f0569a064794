#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "paths/path_scenes.hpp"

namespace polygonal_perception::evaluation {

/// A way to plan paths.
class PathMethod
{
public:
  virtual ~PathMethod() = default;

  virtual std::string name() const = 0;
  /// Takes the obstacles of a scene in, which outlives its queries.
  virtual void prepare(const PathScene& scene) = 0;
  /// @return the length of a path [m]; nothing where none was found
  virtual std::optional<double> plan(const Eigen::Vector2d& start, const Eigen::Vector2d& goal) = 0;
  /// Of the last plan: edges of the visibility graph that were made; 0 where there is no such graph.
  virtual std::size_t graphEdges() const { return 0; }
};

/// This package's.
std::unique_ptr<PathMethod> triangulatedMethod();
/// Minimal Construct as its paper has it, which is exact, too: the reference.
std::unique_ptr<PathMethod> plainMethod();
/// Those of other libraries that were found.
std::vector<std::unique_ptr<PathMethod>> otherMethods();

}  // namespace polygonal_perception::evaluation

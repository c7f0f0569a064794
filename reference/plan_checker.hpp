#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "polygonal_perception/geometry/polygon_set.hpp"
#include "polygonal_perception/planning/path_planner.hpp"

namespace polygonal_perception::reference {

/// What a plan promises, whatever the obstacles are, and that it cuts none where they are valid.
class PlanChecker
{
public:
  /// @param obstacles  must outlive the checker
  explicit PlanChecker(const geometry::PolygonSet& obstacles);

  bool areValid() const { return are_valid_; }

  /// @return what is wrong with a plan; empty where nothing is
  std::string faultOf(const planning::Plan& plan, const Eigen::Vector2d& start, const Eigen::Vector2d& goal,
                      double tolerance) const;

private:
  /// Whether an inner point of an obstacle is on a segment.
  bool cuts(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;

  const geometry::PolygonSet& obstacles_;
  bool are_valid_;
};

}  // namespace polygonal_perception::reference

#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <polygonal_perception/PolygonArray.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/planning/path_parameters.hpp"
#include "polygonal_perception/planning/path_planner.hpp"
#include "polygonal_perception/ros/common/expected.hpp"
#include "polygonal_perception/ros/common/tf_bridge.hpp"

namespace polygonal_perception::ros_planning {

/// Plans on the newest PolygonArray, between poses in any frame that tf knows.
class POLYGONAL_PERCEPTION_EXPORT PolygonPlanner
{
public:
  /// On the floor, in the polygons' frame.
  struct Place
  {
    Eigen::Vector2d point;
    std::optional<double> yaw;  ///< [rad] nothing: any
  };

  /// They are taken in when a plan is wanted.
  void setPolygons(const PolygonArrayConstPtr& polygons);
  /// Null before the first.
  const PolygonArrayConstPtr& polygons() const { return polygons_; }
  /// Whether paths may leave the polygons' extent.
  void setOutsideIsFree(bool is_free);
  /// Of another time is all that is known: polygons, transforms, and the side of obstacles.
  void forget();

  /// Takes the polygons in, if that has not been done.
  /// @return what is wrong with them; empty where they can be planned on
  std::string takeIn();

  /// Where a pose is; of one without an orientation (its quaternion all 0) with any yaw.
  ros_common::Expected<Place> locate(const geometry_msgs::PoseStamped& pose) const;
  /// The transform that takes points of a frame into another one, at the polygons' stamp.
  ros_common::Expected<Eigen::Isometry3d> transform(const std::string& target,
                                                    const std::string& source) const;
  /// A pose moved from its frame into a fixed one, at a stamp.
  ros_common::Expected<geometry_msgs::PoseStamped> moved(const geometry_msgs::PoseStamped& pose,
                                                         const std::string& fixed_frame,
                                                         const ros::Time& stamp) const;

  /// The shortest path, on polygons that have been taken in.
  /// @param tolerance  [m] how far from a goal in an obstacle it may end
  /// @param plan       replaced
  void makePlan(const Place& start, const Place& goal, double tolerance, planning::Plan& plan)
  {
    planner_.makePlan(start.point, goal.point, tolerance, plan);
  }
  /// Has the plan just made pass obstacles on the side on which the last one to that goal did.
  ///
  /// @param fixed_frame  in which obstacles stand still
  /// @param rules        its side_hysteresis counts, and a goal no farther than its goal_tolerance from the last one is the
  ///                     same
  void keepSide(const std::string& fixed_frame, const planning::PathParameters& rules, const Place& goal,
                planning::Plan& plan);
  /// Of the last plan, for pictures.
  const planning::PathSearch& search() const { return planner_.search(); }

private:
  ros_common::TfBridge tf_;
  planning::PathPlanner planner_;
  PolygonArrayConstPtr polygons_;
  bool outside_is_free_ = true;
  bool are_taken_in_ = false;
  std::string fault_;                   // of the polygons, once they are taken in
  std::vector<Eigen::Vector2d> guide_;  // [m] of the last plan, in the fixed frame
};

/// What an outcome is called in PlanStatus.
POLYGONAL_PERCEPTION_EXPORT std::uint8_t statusOf(planning::PlanOutcome outcome);
/// A sentence about a plan.
POLYGONAL_PERCEPTION_EXPORT std::string textOf(const planning::Plan& plan);

}  // namespace polygonal_perception::ros_planning

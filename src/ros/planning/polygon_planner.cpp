#include "polygonal_perception/ros/planning/polygon_planner.hpp"

#include <algorithm>
#include <cmath>

#include "polygonal_perception/ros/common/marker_parts.hpp"
#include "polygonal_perception/ros/common/polygon_messages.hpp"

namespace polygonal_perception::ros_planning {

using ros_common::Expected;

namespace {

double yawOf(const Eigen::Matrix3d& rotation)
{
  return std::atan2(rotation(1, 0), rotation(0, 0));
}

bool hasOrientation(const geometry_msgs::Pose& pose)
{
  const auto& q = pose.orientation;
  const double square = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
  return square > 0.0 && std::isfinite(square);  // of numbers that are none it is none
}

Eigen::Isometry3d toIsometry(const geometry_msgs::Pose& pose)
{
  const auto& q = pose.orientation;
  const Eigen::Quaterniond rotation(q.w, q.x, q.y, q.z);
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  if (hasOrientation(pose)) result.linear() = rotation.normalized().toRotationMatrix();
  result.translation() << pose.position.x, pose.position.y, pose.position.z;
  return result;
}

}  // namespace

void PolygonPlanner::setPolygons(const PolygonArrayConstPtr& polygons)
{
  if (polygons_ == polygons) return;
  polygons_ = polygons;
  are_taken_in_ = false;
}

void PolygonPlanner::setOutsideIsFree(bool is_free)
{
  are_taken_in_ = are_taken_in_ && outside_is_free_ == is_free;
  outside_is_free_ = is_free;
}

void PolygonPlanner::forget()
{
  tf_.clear();
  polygons_.reset();
  guide_.clear();
}

std::string PolygonPlanner::takeIn()
{
  if (are_taken_in_) return fault_;
  are_taken_in_ = true;
  fault_.clear();
  if (polygons_->floor_status == FloorPlane::NOT_FOUND && polygons_->polygons.empty())
    return fault_ = "without a floor nobody knows what stands where";
  const auto obstacles = ros_common::toPolygonSet(*polygons_);
  if (!obstacles) return fault_ = obstacles.error();
  const auto refused =
      planner_.setObstacles(*obstacles, ros_common::toVertices(polygons_->extent), outside_is_free_);
  if (refused) fault_ = "polygons: " + refused->text;
  return fault_;
}

Expected<PolygonPlanner::Place> PolygonPlanner::locate(const geometry_msgs::PoseStamped& pose) const
{
  Eigen::Isometry3d place = toIsometry(pose.pose);
  if (!pose.header.frame_id.empty()) {
    const auto to_polygons = transform(polygons_->header.frame_id, pose.header.frame_id);
    if (!to_polygons) return Expected<Place>::failure(to_polygons.error());
    place = *to_polygons * place;
  }
  Place on_floor{place.translation().head<2>(), std::nullopt};
  if (hasOrientation(pose.pose)) on_floor.yaw = yawOf(place.linear());
  return on_floor;
}

Expected<Eigen::Isometry3d> PolygonPlanner::transform(const std::string& target,
                                                      const std::string& source) const
{
  if (target == source) return Eigen::Isometry3d(Eigen::Isometry3d::Identity());
  return tf_.lookup(target, source, polygons_->header.stamp);
}

Expected<geometry_msgs::PoseStamped> PolygonPlanner::moved(const geometry_msgs::PoseStamped& pose,
                                                           const std::string& fixed_frame,
                                                           const ros::Time& stamp) const
{
  const auto transform = tf_.lookup(fixed_frame, pose.header.frame_id, stamp);
  if (!transform) return Expected<geometry_msgs::PoseStamped>::failure(transform.error());
  const Eigen::Isometry3d place = *transform * toIsometry(pose.pose);
  geometry_msgs::PoseStamped moved = pose;
  moved.header.frame_id = fixed_frame;
  moved.pose.position = ros_common::point(place.translation());
  if (!hasOrientation(pose.pose)) return moved;
  const Eigen::Quaterniond rotation(place.linear());
  moved.pose.orientation.x = rotation.x();
  moved.pose.orientation.y = rotation.y();
  moved.pose.orientation.z = rotation.z();
  moved.pose.orientation.w = rotation.w();
  return moved;
}

void PolygonPlanner::keepSide(const std::string& fixed_frame, const planning::PathParameters& rules,
                              const Place& goal, planning::Plan& plan)
{
  // A goal sent again is not quite the same, and that of who follows a person moves on.
  const double same_goal = std::max(rules.goal_tolerance, 0.05);  // [m]
  const auto to_fixed = transform(fixed_frame, polygons_->header.frame_id);
  if (!to_fixed) return guide_.clear();
  const auto moveGuide = [this](const Eigen::Isometry3d& transform) {
    for (Eigen::Vector2d& p : guide_) p = (transform * Eigen::Vector3d(p.x(), p.y(), 0.0)).head<2>();
  };
  moveGuide(to_fixed->inverse());
  if (!guide_.empty() && (guide_.back() - goal.point).norm() > same_goal) guide_.clear();
  planner_.keepSide(rules.side_hysteresis, guide_, plan);
  moveGuide(*to_fixed);
}

}  // namespace polygonal_perception::ros_planning

#include "ros/driving/drive_inputs.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

#include "polygonal_perception/ros/common/polygon_messages.hpp"
#include "polygonal_perception/ros/common/text_rules.hpp"

namespace polygonal_perception::ros_driving {

using planning::MovingEdge;
using ros_common::Expected;

namespace {

double yawOf(const geometry_msgs::Quaternion& q)
{
  return std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
}

void move(const Eigen::Isometry2d& place, geometry::PolygonSet& polygons)
{
  for (Eigen::Vector2d& p : polygons.vertices) p = place * p;
}

/// [m/s] The greatest standard deviation of a velocity, in any direction; nothing for a matrix that is no covariance.
std::optional<double> deviation(const TrackedPolygon::_velocity_covariance_type& covariance)
{
  Eigen::Matrix2d matrix;
  matrix << covariance[0], covariance[1], covariance[2], covariance[3];
  if (!matrix.allFinite()) return std::nullopt;
  const Eigen::Vector2d values =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(0.5 * (matrix + matrix.transpose())).eigenvalues();
  if (values.minCoeff() < -1e-9 || !values.allFinite()) return std::nullopt;
  return std::sqrt(std::max(0.0, values.maxCoeff()));
}

}  // namespace

Expected<DriveInputs::Edges> DriveInputs::standing(const PolygonArray& polygons,
                                                   const std::string& frame) const
{
  const auto place = this->place(polygons.header, frame);
  if (!place) return Expected<Edges>::failure("polygons: " + place.error());
  auto set = ros_common::toPolygonSet(polygons);
  if (!set) return Expected<Edges>::failure(set.error());
  geometry::PolygonSet moved = *set;
  move(*place, moved);
  Edges edges;
  planning::appendMovingEdges(moved, Eigen::Vector2d::Zero(), 0.0, edges);
  return edges;
}

Expected<DriveInputs::Edges> DriveInputs::moving(const TrackedPolygonArray& polygons, double sigmas,
                                                 const std::string& frame) const
{
  const auto place = this->place(polygons.header, frame);
  if (!place) return Expected<Edges>::failure("tracked_polygons: " + place.error());
  Edges edges;
  for (const TrackedPolygon& polygon : polygons.polygons) {
    const std::string name = "tracked polygon " + std::to_string(polygon.id) + ": ";
    const auto set = ros_common::toPolygonSet(polygon.polygon);
    if (!set) return Expected<Edges>::failure(name + set.error());
    const Eigen::Vector2d velocity =
        place->linear() * Eigen::Vector2d(polygon.velocity.x, polygon.velocity.y);
    const auto sigma = deviation(polygon.velocity_covariance);
    if (!velocity.allFinite()) return Expected<Edges>::failure(name + "its velocity is not finite");
    if (!sigma) return Expected<Edges>::failure(name + "velocity_covariance is no covariance");
    geometry::PolygonSet moved = *set;
    move(*place, moved);
    planning::appendMovingEdges(moved, velocity, sigmas * *sigma, edges);
  }
  return edges;
}

Expected<DrivenPath> DriveInputs::path(const nav_msgs::Path& path, const std::string& frame) const
{
  const auto place = this->place(path.header, frame);
  if (!place) return Expected<DrivenPath>::failure("path: " + place.error());
  DrivenPath driven;
  for (const geometry_msgs::PoseStamped& pose : path.poses) {
    const Eigen::Vector2d p(pose.pose.position.x, pose.pose.position.y);
    if (!p.allFinite()) return Expected<DrivenPath>::failure("path: a position is not finite");
    driven.points.push_back(*place * p);
  }
  const double yaw = yawOf(path.poses.back().pose.orientation);
  if (!std::isfinite(yaw)) return Expected<DrivenPath>::failure("path: the last orientation is not finite");
  driven.goal_yaw = yaw + Eigen::Rotation2Dd(place->linear()).angle();
  return driven;
}

Expected<planning::RobotState> DriveInputs::state(const nav_msgs::Odometry& odometry)
{
  const auto& pose = odometry.pose.pose;
  const auto& twist = odometry.twist.twist;
  planning::RobotState state{{{pose.position.x, pose.position.y}, yawOf(pose.orientation)},
                             {twist.linear.x, twist.linear.y, twist.angular.z}};
  const double sum =
      state.pose.position.sum() + state.pose.yaw + state.velocity.x + state.velocity.y + state.velocity.theta;
  if (std::isfinite(sum)) return state;
  return Expected<planning::RobotState>::failure("odom: pose or twist is not finite");
}

Expected<Eigen::Isometry2d> DriveInputs::place(const std_msgs::Header& header, const std::string& frame) const
{
  if (header.frame_id == frame) return Eigen::Isometry2d(Eigen::Isometry2d::Identity());
  if (const std::string error = ros_common::frameIdError(header.frame_id); !error.empty())
    return Expected<Eigen::Isometry2d>::failure(error);
  const auto transform = tf_.lookup(frame, header.frame_id, header.stamp);
  if (!transform) return Expected<Eigen::Isometry2d>::failure(transform.error());
  const double yaw = std::atan2((*transform)(1, 0), (*transform)(0, 0));
  return Eigen::Isometry2d(Eigen::Translation2d(transform->translation().head<2>()) *
                           Eigen::Rotation2Dd(yaw));
}

}  // namespace polygonal_perception::ros_driving

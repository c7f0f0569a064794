#include "ros/driving/drive_inputs.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

#include "polygonal_perception/geometry/validity.hpp"
#include "polygonal_perception/ros/common/planar_pose.hpp"
#include "polygonal_perception/ros/common/polygon_messages.hpp"
#include "polygonal_perception/ros/common/text_rules.hpp"

namespace polygonal_perception::ros_driving {

using planning::MovingEdge;
using ros_common::Expected;

namespace {

constexpr double kFastest = 100.0;  // [m/s, rad/s] what says that it is faster is wrong

geometry::PolygonSet moved(geometry::PolygonSet polygons, const Eigen::Isometry2d& place)
{
  for (Eigen::Vector2d& p : polygons.vertices) p = place * p;
  return polygons;
}

/// Reads polygons of which none gets lost: one that runs the wrong way, or crosses itself, would be open from outside.
Expected<geometry::PolygonSet> read(const ObstaclePolygon& polygon, const std::string& name)
{
  auto set = ros_common::toPolygonSet(polygon);
  if (!set) return Expected<geometry::PolygonSet>::failure(name + set.error());
  if (const auto defect = geometry::findDefect(*set))
    return Expected<geometry::PolygonSet>::failure(name + defect->text);
  return set;
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
  Edges edges;
  for (std::size_t k = 0; k < polygons.polygons.size(); ++k) {
    const auto set = read(polygons.polygons[k], "polygon " + std::to_string(k) + ": ");
    if (!set) return Expected<Edges>::failure(set.error());
    planning::appendMovingEdges(moved(*set, *place), Eigen::Vector2d::Zero(), 0.0, edges);
  }
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
    const auto set = read(polygon.polygon, name);
    if (!set) return Expected<Edges>::failure(set.error());
    const Eigen::Vector2d velocity =
        place->linear() * Eigen::Vector2d(polygon.velocity.x, polygon.velocity.y);
    const auto sigma = deviation(polygon.velocity_covariance);
    if (!(velocity.norm() <= kFastest))
      return Expected<Edges>::failure(name + "velocity is not finite, or above 100 m/s");
    if (!sigma || !(*sigma <= kFastest))
      return Expected<Edges>::failure(name +
                                      "velocity_covariance is no covariance, or that of more than 100 m/s");
    planning::appendMovingEdges(moved(*set, *place), velocity, sigmas * *sigma, edges);
  }
  return edges;
}

Expected<DrivenPath> DriveInputs::path(const nav_msgs::Path& path, const std::string& frame) const
{
  const auto place = this->place(path.header, frame);
  if (!place) return Expected<DrivenPath>::failure("path: " + place.error());
  DrivenPath driven;
  for (const geometry_msgs::PoseStamped& pose : path.poses) {
    const geometry_msgs::Point& p = pose.pose.position;
    if (!ros_common::isPlace(p))
      return Expected<DrivenPath>::failure("path: a position is not finite, or farther than 1000 km away");
    driven.points.push_back(*place * Eigen::Vector2d(p.x, p.y));
  }
  const geometry_msgs::Quaternion& goal = path.poses.back().pose.orientation;
  if (!ros_common::isRotation(goal))
    return Expected<DrivenPath>::failure("path: the last orientation is no unit quaternion");
  driven.goal_yaw = ros_common::yawOf(goal) + Eigen::Rotation2Dd(place->linear()).angle();
  return driven;
}

Expected<planning::RobotState> DriveInputs::state(const nav_msgs::Odometry& odometry)
{
  const auto& pose = odometry.pose.pose;
  const auto& twist = odometry.twist.twist;
  using Result = Expected<planning::RobotState>;
  if (const std::string error = ros_common::frameIdError(odometry.header.frame_id); !error.empty())
    return Result::failure("odom: " + error);
  if (!ros_common::isPlace(pose.position) || !ros_common::isRotation(pose.orientation))
    return Result::failure("odom: pose is none, accepted is a place within 1000 km and a unit quaternion");
  const planning::RobotState state{{{pose.position.x, pose.position.y}, ros_common::yawOf(pose.orientation)},
                                   {twist.linear.x, twist.linear.y, twist.angular.z}};
  if (!(state.velocity.speed() <= kFastest && std::abs(state.velocity.theta) <= kFastest))
    return Result::failure("odom: twist is not finite, or above 100 m/s or rad/s");
  return state;
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

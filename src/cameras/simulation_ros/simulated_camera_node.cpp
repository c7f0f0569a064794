#include "polygonal_perception/cameras/simulation_ros/simulated_camera_node.hpp"

#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "cameras/simulation_ros/camera_topics.hpp"
#include "cameras/simulation_ros/simulated_camera_messages.hpp"
#include "cameras/simulation_ros/simulated_camera_parameters.hpp"
#include "polygonal_perception/cameras/simulation/driven_robot.hpp"
#include "polygonal_perception/ros/common/parameter_holder.hpp"

namespace polygonal_perception::simulation_ros {

class SimulatedCameraNode::Implementation
{
public:
  Implementation(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle);
  ~Implementation() { timer_.stop(); }

private:
  void addRobot(const ros::NodeHandle& handle);
  void tick();
  void drive(double time, const ros::Time& stamp);
  void publishTransforms(std::uint32_t index, const ros::Time& stamp);
  void publishObstacles(std::uint32_t index, const ros::Time& stamp);

  ros_common::ParameterHolder<SimulatedCameraParameters> parameters_;
  std::unique_ptr<const simulation::Scene> scene_;  // that the robot drives in, if it is driven
  std::shared_ptr<simulation::DrivenRobot> robot_;
  std::uint32_t bumps_ = 0;  // that have been told
  ros::Subscriber command_;
  ros::Publisher odometry_;
  std::vector<std::unique_ptr<CameraTopics>> cameras_;  // at least one
  ros::Publisher true_obstacles_;
  tf2_ros::TransformBroadcaster tf_;
  tf2_ros::StaticTransformBroadcaster static_tf_;
  ros::Time start_;
  ros::Timer timer_;
};

SimulatedCameraNode::Implementation::Implementation(const ros::NodeHandle& handle,
                                                    const ros::NodeHandle& private_handle)
    : parameters_(private_handle)
{
  if (parameters_->isDriven()) addRobot(handle);
  for (std::uint32_t i = 0; i < parameters_->cameraNames().size(); ++i)
    cameras_.push_back(std::make_unique<CameraTopics>(handle, private_handle, *parameters_, i, robot_));
  true_obstacles_ = ros::NodeHandle(private_handle, "ground_truth").advertise<PolygonArray>("obstacles", 1);

  start_ = ros::Time::now();
  if (parameters_->publish_tf) {
    std::vector<geometry_msgs::TransformStamped> turns;
    for (const auto& camera : cameras_)
      turns.push_back(toOpticalTransform(start_, camera->names().body_frame, camera->names().optical_frame));
    static_tf_.sendTransform(turns);
  }
  timer_ = ros::NodeHandle(handle).createTimer(ros::Duration(1.0 / parameters_->rate),
                                               [this](const ros::TimerEvent&) { tick(); });
}

void SimulatedCameraNode::Implementation::addRobot(const ros::NodeHandle& handle)
{
  const auto options = parameters_->options(0);
  scene_ = std::make_unique<simulation::Scene>(simulation::makeScene(options.scene, options.seed));
  robot_ = std::make_shared<simulation::DrivenRobot>(*scene_, options.seed, parameters_->robot);
  ros::NodeHandle robot_handle(handle);
  odometry_ = robot_handle.advertise<nav_msgs::Odometry>("odom", 1);
  const boost::function<void(const geometry_msgs::TwistConstPtr&)> obey =
      [this](const geometry_msgs::TwistConstPtr& twist) {
        const planning::Twist command{twist->linear.x, twist->linear.y, twist->angular.z};
        if (!std::isfinite(command.x + command.y + command.theta)) {
          ROS_ERROR_THROTTLE(5.0, "cmd_vel is not finite");
          return;
        }
        robot_->command(command);
      };
  command_ = robot_handle.subscribe<geometry_msgs::Twist>("cmd_vel", 1, obey);
}

void SimulatedCameraNode::Implementation::drive(double time, const ros::Time& stamp)
{
  robot_->advanceTo(time);
  odometry_.publish(toOdometry(robot_->state(), stamp, parameters_->world_frame, parameters_->base_frame));
  if (robot_->bumps() == bumps_) return;
  bumps_ = robot_->bumps();
  ROS_WARN("the robot has bumped into something: %u times now", bumps_);
}

void SimulatedCameraNode::Implementation::tick()
{
  const ros::Time stamp = ros::Time::now();
  // After a jump back in time everything begins again.
  if (stamp < start_) start_ = stamp;
  const auto index = static_cast<std::uint32_t>(std::lround((stamp - start_).toSec() * parameters_->rate));
  if (robot_) drive((stamp - start_).toSec(), stamp);
  if (parameters_->publish_tf) publishTransforms(index, stamp);
  for (const auto& camera : cameras_) camera->publish(index, stamp);
  if (true_obstacles_.getNumSubscribers() > 0) publishObstacles(index, stamp);
}

void SimulatedCameraNode::Implementation::publishTransforms(std::uint32_t index, const ros::Time& stamp)
{
  const Eigen::Isometry3d base = cameras_.front()->camera().base(index);
  std::vector<geometry_msgs::TransformStamped> transforms{
      toTransform(base, stamp, parameters_->world_frame, parameters_->base_frame)};
  for (const auto& camera : cameras_) {
    transforms.push_back(toTransform(base.inverse() * bodyPose(camera->camera().pose(index)), stamp,
                                     parameters_->base_frame, camera->names().body_frame));
  }
  tf_.sendTransform(transforms);
}

void SimulatedCameraNode::Implementation::publishObstacles(std::uint32_t index, const ros::Time& stamp)
{
  std_msgs::Header world;
  world.stamp = stamp;
  world.frame_id = parameters_->world_frame;
  const double time = index / parameters_->rate;
  true_obstacles_.publish(boost::make_shared<PolygonArray>(toPolygons(
      cameras_.front()->camera().scene().obstacles(time, parameters_->min_height, parameters_->max_height),
      world)));
}

SimulatedCameraNode::SimulatedCameraNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle)
    : implementation_(std::make_unique<Implementation>(handle, private_handle))
{
}
SimulatedCameraNode::~SimulatedCameraNode() = default;

}  // namespace polygonal_perception::simulation_ros

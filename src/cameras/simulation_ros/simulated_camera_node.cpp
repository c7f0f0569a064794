#include "polygonal_perception/cameras/simulation_ros/simulated_camera_node.hpp"

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
#include "polygonal_perception/ros/common/parameter_holder.hpp"

namespace polygonal_perception::simulation_ros {

class SimulatedCameraNode::Implementation
{
public:
  Implementation(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle);
  ~Implementation() { timer_.stop(); }

private:
  void tick();
  void publishTransforms(std::uint32_t index, const ros::Time& stamp);
  void publishObstacles(std::uint32_t index, const ros::Time& stamp);

  ros_common::ParameterHolder<SimulatedCameraParameters> parameters_;
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
  for (std::uint32_t i = 0; i < parameters_->cameraNames().size(); ++i)
    cameras_.push_back(std::make_unique<CameraTopics>(handle, private_handle, *parameters_, i));
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

void SimulatedCameraNode::Implementation::tick()
{
  const ros::Time stamp = ros::Time::now();
  // After a jump back in time everything begins again.
  if (stamp < start_) start_ = stamp;
  const auto index = static_cast<std::uint32_t>(std::lround((stamp - start_).toSec() * parameters_->rate));
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

#include "polygonal_perception/cameras/simulation_ros/simulated_camera_node.hpp"

#include <image_transport/image_transport.h>
#include <ros/ros.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

#include <cmath>
#include <cstdint>

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
  bool frameIsRead() const;
  void publishFrame(const ros::Time& stamp);

  ros_common::ParameterHolder<SimulatedCameraParameters> parameters_;
  simulation::SimulatedCamera camera_;
  simulation::SimulatedFrame frame_;
  std::uint32_t sequence_ = 0;  // of the last frame: roscpp numbers messages for other processes only

  image_transport::CameraPublisher raw_;
  image_transport::Publisher rectified_;
  ros::Publisher points_;
  ros::Publisher true_floor_;
  ros::Publisher true_obstacles_;
  tf2_ros::TransformBroadcaster tf_;
  tf2_ros::StaticTransformBroadcaster static_tf_;
  ros::Time start_;
  ros::Timer timer_;
};

SimulatedCameraNode::Implementation::Implementation(const ros::NodeHandle& handle,
                                                    const ros::NodeHandle& private_handle)
    : parameters_(private_handle), camera_(parameters_->options())
{
  ros::NodeHandle camera_handle(handle, parameters_->camera);
  image_transport::ImageTransport transport(camera_handle);
  raw_ = transport.advertiseCamera("depth/image_raw", 1);
  rectified_ = transport.advertise("depth/image_rect", 1);
  points_ = camera_handle.advertise<sensor_msgs::PointCloud2>("depth/points", 1);
  ros::NodeHandle truth_handle(private_handle, "ground_truth");
  true_floor_ = truth_handle.advertise<FloorPlane>("floor", 1);
  true_obstacles_ = truth_handle.advertise<PolygonArray>("obstacles", 1);

  start_ = ros::Time::now();
  if (parameters_->publish_tf) {
    static_tf_.sendTransform(
        toOpticalTransform(start_, parameters_->camera_frame, parameters_->optical_frame));
  }
  timer_ = ros::NodeHandle(handle).createTimer(ros::Duration(1.0 / camera_.options().rate),
                                               [this](const ros::TimerEvent&) { tick(); });
}

void SimulatedCameraNode::Implementation::tick()
{
  const ros::Time stamp = ros::Time::now();
  // After a jump back in time everything begins again.
  if (stamp < start_) start_ = stamp;
  const auto index =
      static_cast<std::uint32_t>(std::lround((stamp - start_).toSec() * camera_.options().rate));
  if (parameters_->publish_tf) {
    tf_.sendTransform(toTransforms(camera_.pose(index), camera_.base(index), stamp, parameters_->world_frame,
                                   parameters_->base_frame, parameters_->camera_frame));
  }
  if (frameIsRead()) {
    camera_.render(index, frame_);
    publishFrame(stamp);
  }
  if (true_obstacles_.getNumSubscribers() > 0) {
    std_msgs::Header world;
    world.stamp = stamp;
    world.frame_id = parameters_->world_frame;
    const double time = index / camera_.options().rate;
    true_obstacles_.publish(boost::make_shared<PolygonArray>(toPolygons(
        camera_.scene().obstacles(time, parameters_->min_height, parameters_->max_height), world)));
  }
}

bool SimulatedCameraNode::Implementation::frameIsRead() const
{
  return raw_.getNumSubscribers() > 0 || rectified_.getNumSubscribers() > 0 ||
         points_.getNumSubscribers() > 0 || true_floor_.getNumSubscribers() > 0;
}

void SimulatedCameraNode::Implementation::publishFrame(const ros::Time& stamp)
{
  const simulation::PinholeCamera& camera = camera_.options().camera;
  std_msgs::Header header;
  header.seq = ++sequence_;
  header.stamp = stamp;
  header.frame_id = parameters_->optical_frame;
  if (raw_.getNumSubscribers() > 0 || rectified_.getNumSubscribers() > 0) {
    // A pinhole's raw image is rectified.
    const sensor_msgs::ImageConstPtr image = toImage(frame_, camera, header);
    raw_.publish(image, boost::make_shared<sensor_msgs::CameraInfo>(toCameraInfo(camera, header)));
    rectified_.publish(image);
  }
  if (points_.getNumSubscribers() > 0) points_.publish(toCloud(frame_, camera, header));
  if (true_floor_.getNumSubscribers() > 0)
    true_floor_.publish(boost::make_shared<FloorPlane>(toFloor(frame_, header)));
}

SimulatedCameraNode::SimulatedCameraNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle)
    : implementation_(std::make_unique<Implementation>(handle, private_handle))
{
}
SimulatedCameraNode::~SimulatedCameraNode() = default;

}  // namespace polygonal_perception::simulation_ros

#include "cameras/simulation_ros/camera_topics.hpp"

#include <ros/node_handle.h>

#include "cameras/simulation_ros/simulated_camera_messages.hpp"

namespace polygonal_perception::simulation_ros {

CameraTopics::CameraTopics(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
                           const SimulatedCameraParameters& parameters, std::uint32_t number,
                           const std::shared_ptr<const simulation::Trajectory>& robot)
    : names_(parameters.cameraNames()[number]), camera_(parameters.options(number), robot)
{
  ros::NodeHandle camera_handle(handle, names_.topics);
  image_transport::ImageTransport transport(camera_handle);
  raw_ = transport.advertiseCamera("depth/image_raw", 1);
  rectified_ = transport.advertise("depth/image_rect", 1);
  points_ = camera_handle.advertise<sensor_msgs::PointCloud2>("depth/points", 1);
  true_floor_ = ros::NodeHandle(private_handle, names_.truth).advertise<FloorPlane>("floor", 1);
}

void CameraTopics::publish(std::uint32_t index, const ros::Time& stamp)
{
  const bool image_is_read = raw_.getNumSubscribers() > 0 || rectified_.getNumSubscribers() > 0;
  const bool cloud_is_read = points_.getNumSubscribers() > 0;
  const bool floor_is_read = true_floor_.getNumSubscribers() > 0;
  if (!image_is_read && !cloud_is_read && !floor_is_read) return;

  camera_.render(index, frame_);
  const simulation::PinholeCamera& pinhole = camera_.options().camera;
  std_msgs::Header header;
  header.seq = ++sequence_;
  header.stamp = stamp;
  header.frame_id = names_.optical_frame;
  if (image_is_read) {
    // A pinhole's raw image is rectified.
    const sensor_msgs::ImageConstPtr image = toImage(frame_, pinhole, header);
    raw_.publish(image, boost::make_shared<sensor_msgs::CameraInfo>(toCameraInfo(pinhole, header)));
    rectified_.publish(image);
  }
  if (cloud_is_read) points_.publish(toCloud(frame_, pinhole, header));
  if (floor_is_read) true_floor_.publish(boost::make_shared<FloorPlane>(toFloor(frame_, header)));
}

}  // namespace polygonal_perception::simulation_ros

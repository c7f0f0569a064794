#include "cameras/simulation_ros/simulated_camera_messages.hpp"

#include <boost/make_shared.hpp>
#include <cmath>
#include <cstring>

#include "polygonal_perception/ros/common/polygon_messages.hpp"

namespace polygonal_perception::simulation_ros {
namespace {

constexpr std::uint32_t kPointStep = 16;

/// The pose of the optical frame (x right, y down) in the body frame (x forward, y left).
Eigen::Isometry3d opticalInBody()
{
  return simulation::opticalPose(Eigen::Vector3d::Zero(), 0.0, 0.0, 0.0);
}

}  // namespace

sensor_msgs::ImagePtr toImage(const simulation::SimulatedFrame& frame,
                              const simulation::PinholeCamera& camera, const std_msgs::Header& header)
{
  auto image = boost::make_shared<sensor_msgs::Image>();
  image->header = header;
  image->width = camera.width;
  image->height = camera.height;
  image->encoding = "16UC1";
  image->step = camera.width * static_cast<std::uint32_t>(sizeof(std::uint16_t));
  std::vector<std::uint16_t> millimetres(camera.size());
  simulation::toMillimetres(frame.depth, millimetres.data());
  image->data.resize(millimetres.size() * sizeof(std::uint16_t));
  std::memcpy(image->data.data(), millimetres.data(), image->data.size());
  return image;
}

sensor_msgs::CameraInfo toCameraInfo(const simulation::PinholeCamera& camera, const std_msgs::Header& header)
{
  sensor_msgs::CameraInfo info;
  info.header = header;
  info.width = camera.width;
  info.height = camera.height;
  info.distortion_model = "plumb_bob";
  info.D.assign(5, 0.0);
  info.K = {camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0};
  info.R = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  info.P = {camera.fx, 0.0, camera.cx, 0.0, 0.0, camera.fy, camera.cy, 0.0, 0.0, 0.0, 1.0, 0.0};
  return info;
}

sensor_msgs::PointCloud2Ptr toCloud(const simulation::SimulatedFrame& frame,
                                    const simulation::PinholeCamera& camera, const std_msgs::Header& header)
{
  auto cloud = boost::make_shared<sensor_msgs::PointCloud2>();
  cloud->header = header;
  cloud->width = camera.width;
  cloud->height = camera.height;
  cloud->point_step = kPointStep;
  cloud->row_step = kPointStep * camera.width;
  cloud->is_dense = 0U;
  cloud->fields.resize(3);
  for (std::uint32_t i = 0; i < 3; ++i) {
    cloud->fields[i].name = std::string(1, static_cast<char>('x' + i));
    cloud->fields[i].offset = i * static_cast<std::uint32_t>(sizeof(float));
    cloud->fields[i].datatype = sensor_msgs::PointField::FLOAT32;
    cloud->fields[i].count = 1;
  }
  cloud->data.resize(std::size_t{cloud->row_step} * camera.height);
  std::uint8_t* out = cloud->data.data();
  const float* depth = frame.depth.data();
  for (std::uint32_t v = 0; v < camera.height; ++v) {
    const auto row_slope = static_cast<float>((v - camera.cy) / camera.fy);
    for (std::uint32_t u = 0; u < camera.width; ++u) {
      const float z = *depth++;
      const auto column_slope = static_cast<float>((u - camera.cx) / camera.fx);
      const float point[3] = {z * column_slope, z * row_slope, z};
      std::memcpy(out, point, sizeof point);
      out += kPointStep;
    }
  }
  return cloud;
}

FloorPlane toFloor(const simulation::SimulatedFrame& frame, const std_msgs::Header& header)
{
  FloorPlane floor;
  floor.header = header;
  floor.status = frame.floor_fraction > 0.0 ? FloorPlane::FOUND : FloorPlane::NOT_FOUND;
  floor.normal.x = frame.floor.normal.x();
  floor.normal.y = frame.floor.normal.y();
  floor.normal.z = frame.floor.normal.z();
  floor.distance = frame.floor.distance;
  floor.sample_count =
      static_cast<std::uint32_t>(std::lround(frame.floor_fraction * static_cast<double>(frame.depth.size())));
  return floor;
}

PolygonArray toPolygons(const std::vector<simulation::Outline>& outlines, const std_msgs::Header& header)
{
  PolygonArray polygons;
  polygons.header = header;
  polygons.floor_status = FloorPlane::FOUND;
  polygons.polygons.reserve(outlines.size());
  for (const simulation::Outline& outline : outlines) {
    polygons.polygons.emplace_back().boundary = ros_common::toPolygon(outline);
  }
  return polygons;
}

geometry_msgs::TransformStamped toTransform(const Eigen::Isometry3d& pose, const ros::Time& stamp,
                                            const std::string& parent, const std::string& child)
{
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = stamp;
  transform.header.frame_id = parent;
  transform.child_frame_id = child;
  transform.transform.translation.x = pose.translation().x();
  transform.transform.translation.y = pose.translation().y();
  transform.transform.translation.z = pose.translation().z();
  const Eigen::Quaterniond rotation(pose.linear());
  transform.transform.rotation.x = rotation.x();
  transform.transform.rotation.y = rotation.y();
  transform.transform.rotation.z = rotation.z();
  transform.transform.rotation.w = rotation.w();
  return transform;
}

nav_msgs::OdometryPtr toOdometry(const planning::RobotState& state, const ros::Time& stamp,
                                 const std::string& world, const std::string& base)
{
  auto odometry = boost::make_shared<nav_msgs::Odometry>();
  odometry->header.stamp = stamp;
  odometry->header.frame_id = world;
  odometry->child_frame_id = base;
  odometry->pose.pose.position.x = state.pose.position.x();
  odometry->pose.pose.position.y = state.pose.position.y();
  odometry->pose.pose.orientation.z = std::sin(0.5 * state.pose.yaw);
  odometry->pose.pose.orientation.w = std::cos(0.5 * state.pose.yaw);
  odometry->twist.twist.linear.x = state.velocity.x;
  odometry->twist.twist.linear.y = state.velocity.y;
  odometry->twist.twist.angular.z = state.velocity.theta;
  return odometry;
}

Eigen::Isometry3d bodyPose(const Eigen::Isometry3d& optical_pose)
{
  return optical_pose * opticalInBody().inverse();
}

geometry_msgs::TransformStamped toOpticalTransform(const ros::Time& stamp, const std::string& body,
                                                   const std::string& optical)
{
  return toTransform(opticalInBody(), stamp, body, optical);
}

}  // namespace polygonal_perception::simulation_ros

#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/Odometry.h>
#include <polygonal_perception/FloorPlane.h>
#include <polygonal_perception/PolygonArray.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

#include <string>
#include <vector>

#include "polygonal_perception/cameras/simulation/simulated_camera.hpp"
#include "polygonal_perception/planning/robot_model.hpp"

namespace polygonal_perception::simulation_ros {

/// Millimetres as 16UC1, as openni2_camera publishes them.
sensor_msgs::ImagePtr toImage(const simulation::SimulatedFrame& frame,
                              const simulation::PinholeCamera& camera, const std_msgs::Header& header);

/// A pinhole without distortion.
sensor_msgs::CameraInfo toCameraInfo(const simulation::PinholeCamera& camera, const std_msgs::Header& header);

/// Organised, float32 x, y, z in steps of 16 bytes, NaN where there is no return, as depth_image_proc
/// publishes it.
sensor_msgs::PointCloud2Ptr toCloud(const simulation::SimulatedFrame& frame,
                                    const simulation::PinholeCamera& camera, const std_msgs::Header& header);

/// The true floor. NOT_FOUND where no pixel shows it; the plane is given all the same.
FloorPlane toFloor(const simulation::SimulatedFrame& frame, const std_msgs::Header& header);

/// The true outlines on the floor; they may overlap. They are not inflated, so that inflation_radius is 0.
/// The extent is empty: the truth is no view, and this message does not say where obstacles were looked for.
PolygonArray toPolygons(const std::vector<simulation::Outline>& outlines, const std_msgs::Header& header);

geometry_msgs::TransformStamped toTransform(const Eigen::Isometry3d& pose, const ros::Time& stamp,
                                            const std::string& parent, const std::string& child);

/// Where a robot that is driven is, and how fast it moves in its own frame.
nav_msgs::OdometryPtr toOdometry(const planning::RobotState& state, const ros::Time& stamp,
                                 const std::string& world, const std::string& base);

/// The pose of a camera's body frame (x forward, y left, z up), of that of its optical frame.
Eigen::Isometry3d bodyPose(const Eigen::Isometry3d& optical_pose);

/// The turn from the camera's body frame into its optical frame.
geometry_msgs::TransformStamped toOpticalTransform(const ros::Time& stamp, const std::string& body,
                                                   const std::string& optical);

}  // namespace polygonal_perception::simulation_ros

#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_ros/transform_broadcaster.h>

#include <memory>
#include <optional>
#include <string>

#include "polygonal_perception/perception/pipeline.hpp"
#include "polygonal_perception/ros/common/frame_statistics.hpp"
#include "polygonal_perception/ros/common/parameter_holder.hpp"
#include "polygonal_perception/ros/common/tf_bridge.hpp"
#include "polygonal_perception/ros/common/throttled_log.hpp"
#include "ros/perception/camera_attitude.hpp"
#include "ros/perception/depth_input.hpp"
#include "ros/perception/floor_frame_guard.hpp"
#include "ros/perception/floor_warnings.hpp"
#include "ros/perception/frame_transforms.hpp"
#include "ros/perception/outputs.hpp"
#include "ros/perception/perception_parameters.hpp"

namespace polygonal_perception::ros_perception {

/// A frame in the memory of its publisher: one of the two is set.
struct InputFrame
{
  sensor_msgs::PointCloud2ConstPtr cloud;
  sensor_msgs::ImageConstPtr image;

  const std_msgs::Header& header() const { return cloud ? cloud->header : image->header; }
};

/// Answers frames: gathers what a frame needs from tf and camera_info, runs the pipeline and publishes the
/// result.
class FrameProcessor
{
public:
  /// @param info_topic  where camera_info comes from, for errors
  /// @param parameters, outputs, statistics, log  must outlive it
  FrameProcessor(const PerceptionParameters& parameters, const std::string& info_topic,
                 const Outputs& outputs, ros_common::FrameStatistics& statistics,
                 ros_common::ThrottledLog& log);

  void setCameraInfo(const sensor_msgs::CameraInfoConstPtr& info) { depth_input_.setCameraInfo(info); }

  FloorFrameGuard& floorFrameGuard() { return floor_frame_guard_; }

  /// Answers a frame or says why not. Never throws.
  /// @param may_wait  whether the frame may come again a little later, when its transforms have arrived
  /// @return false when the frame had better wait, and nothing has been done yet
  bool process(const InputFrame& frame, bool may_wait);

  /// Takes on new parameters with the next frame.
  void configure(const perception::Pipeline::Parameters& parameters) { pipeline_.configure(parameters); }

  /// Forgets the floor.
  void resetFloor()
  {
    pipeline_.reset();
    warnings_.reset();
  }
  /// Forgets all that has a time, the floor and the transforms, and says so in the log.
  void resetTime(const std::string& reason);
  /// Of the last frame that was not refused.
  ros::Time lastStamp() const { return last_stamp_; }

  /// As it was answered last.
  const perception::FloorState& floor() const { return pipeline_.result().floor; }
  /// What is ahead, in the input's frame.
  const perception::ViewAxes& heading() const { return pipeline_.result().heading; }
  /// Of the camera above that floor; nothing where there is none.
  std::optional<CameraAttitude> attitude() const;
  /// How it disagrees with the mount, in a sentence; empty where it does not.
  std::string mountDisagreement() const;

private:
  bool processUnguarded(const InputFrame& frame, bool may_wait);
  /// The floor, and what is ahead, are those of a frame: in another they mean nothing.
  void followFrame(const std::string& frame_id);
  std::string frameError(const std::string& frame_id) const;
  perception::Products neededProducts(const FrameTransforms& transforms) const;
  void runPipeline(const std_msgs::Header& header, const perception::PointView& points,
                   const FrameTransforms& transforms);
  OutputPose outputPose(const std::optional<Eigen::Isometry3d>& input_to_output) const;
  /// Whether the floor frame is this camera's; says so where it is not.
  bool ownsFloorFrame(const std::string& frame_id);
  void broadcast(const std_msgs::Header& header);
  void reject(const char* kind, const std::string& reason);

  const PerceptionParameters& parameters_;
  const Outputs& outputs_;
  ros_common::FrameStatistics& statistics_;
  ros_common::ThrottledLog& log_;
  perception::Pipeline pipeline_;
  FloorWarnings warnings_;
  DepthInput depth_input_;
  FloorFrameGuard floor_frame_guard_;
  std::unique_ptr<ros_common::TfBridge> tf_;  // only where a parameter names a frame
  tf2_ros::TransformBroadcaster broadcaster_;
  std::string input_frame_;  // of the last frame
  ros::Time last_stamp_;
  ros::Time last_broadcast_;
};

}  // namespace polygonal_perception::ros_perception

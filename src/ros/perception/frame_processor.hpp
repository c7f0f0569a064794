#pragma once

#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_ros/transform_broadcaster.h>

#include <memory>
#include <optional>
#include <string>

#include "polygonal_perception/perception/pipeline.hpp"
#include "polygonal_perception/ros/common/frame_statistics.hpp"
#include "polygonal_perception/ros/common/tf_bridge.hpp"
#include "polygonal_perception/ros/common/throttled_log.hpp"
#include "ros/perception/camera_attitude.hpp"
#include "ros/perception/depth_input.hpp"
#include "ros/perception/input_frame.hpp"
#include "ros/perception/node_parameters.hpp"
#include "ros/perception/outputs.hpp"

namespace polygonal_perception::ros_perception {

/// Answers frames: gathers what a frame needs from tf and camera_info, runs the pipeline and publishes the
/// result.
class FrameProcessor
{
public:
  /// @param info_topic  where camera_info comes from, for errors
  /// @param outputs, statistics, log  must outlive it
  FrameProcessor(const NodeParameters& parameters, const std::string& info_topic, Outputs& outputs,
                 ros_common::FrameStatistics& statistics, ros_common::ThrottledLog& log);

  void setCameraInfo(const sensor_msgs::CameraInfoConstPtr& info) { depth_input_.setCameraInfo(info); }

  /// Answers a frame or says why not. Never throws.
  /// @param may_wait  whether the frame may come again a little later, when its transforms have arrived
  /// @return false when the frame had better wait, and nothing has been done yet
  bool process(const InputFrame& frame, bool may_wait);

  /// Takes on new parameters with the next frame.
  void configure(const perception::Pipeline::Parameters& parameters) { pipeline_.configure(parameters); }

  /// Forgets the floor.
  void forgetFloor();
  /// Forgets all that has a time: the floor and the transforms.
  void forgetTime();

  /// As it was answered last.
  const perception::FloorState& floor() const { return floor_; }
  /// Of the camera above that floor; nothing where one of the two is unknown.
  std::optional<CameraAttitude> attitude() const;

private:
  /// What tf says of a frame, as far as the parameters ask it.
  struct Transforms
  {
    std::optional<Eigen::Vector3d> up;  // in the input's frame
    std::optional<Eigen::Isometry3d> input_to_output;
    std::string missing_up;  // why it is not there though it is needed, or empty
    std::string missing_output;

    const std::string& missing() const { return missing_output.empty() ? missing_up : missing_output; }
  };

  bool processUnguarded(const InputFrame& frame, bool may_wait);
  Transforms lookUp(const std_msgs::Header& header) const;
  Answer makeAnswer(const std_msgs::Header& header, const perception::PointView& points,
                    const Transforms& transforms);
  std::string frameError(const std::string& frame_id) const;
  void broadcast(const Answer& answer);
  OutputPlace placeOf(const perception::FloorState& floor,
                      const std::optional<Eigen::Isometry3d>& input_to_output) const;
  void reject(const char* kind, const std::string& reason);

  const NodeParameters parameters_;
  Outputs& outputs_;
  ros_common::FrameStatistics& statistics_;
  ros_common::ThrottledLog& log_;
  perception::Pipeline pipeline_;
  DepthInput depth_input_;
  std::unique_ptr<ros_common::TfBridge> tf_;  // only where a parameter names a frame
  tf2_ros::TransformBroadcaster broadcaster_;
  ros::Time last_broadcast_;
  perception::FloorState floor_;
};

}  // namespace polygonal_perception::ros_perception

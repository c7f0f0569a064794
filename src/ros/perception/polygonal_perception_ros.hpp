#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <ros/wall_timer.h>
#include <std_srvs/Trigger.h>

#include <deque>
#include <memory>
#include <string>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/ros/common/callback_gate.hpp"
#include "polygonal_perception/ros/common/frame_statistics.hpp"
#include "polygonal_perception/ros/common/throttled_log.hpp"
#include "ros/perception/camera_subscription.hpp"
#include "ros/perception/frame_processor.hpp"
#include "ros/perception/node_parameters.hpp"
#include "ros/perception/outputs.hpp"
#include "ros/perception/reconfigure_server.hpp"

namespace polygonal_perception::ros_perception {

/// The whole node: what the nodelet and the node executable run, and what needs neither of them to be tested.
///
/// It subscribes to the camera while somebody reads an output, hands each frame to the FrameProcessor, and
/// lets a frame whose transforms are on their way wait without holding up anything else.
///
/// The handles' queue may be served by any thread, one callback at a time, as a nodelet's single-threaded
/// queue is.
class POLYGONAL_PERCEPTION_EXPORT PolygonalPerceptionRos
{
public:
  /// @param handle          where the inputs are
  /// @param private_handle  where parameters, outputs and services are
  PolygonalPerceptionRos(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle);
  ~PolygonalPerceptionRos();

  PolygonalPerceptionRos(const PolygonalPerceptionRos&) = delete;
  PolygonalPerceptionRos& operator=(const PolygonalPerceptionRos&) = delete;

private:
  struct WaitingFrame
  {
    InputFrame frame;
    ros_common::FrameStatistics::Clock::time_point arrival;
  };

  void onFrame(const InputFrame& frame);
  void onCameraInfo(const sensor_msgs::CameraInfoConstPtr& info);
  void advertiseReset();
  void startDiagnostics();
  CameraSubscription::Ended report();
  CameraSubscription::Ended updateSubscription();
  void processWaiting();
  void checkClock();
  void forgetTime(const std::string& reason);
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);

  std::shared_ptr<ros_common::CallbackGate> gate_ = std::make_shared<ros_common::CallbackGate>();
  ros::NodeHandle handle_;
  ros::NodeHandle private_handle_;
  const std::string name_;
  NodeParameters parameters_;
  ros_common::ThrottledLog log_;
  ros_common::FrameStatistics statistics_;
  std::unique_ptr<Outputs> outputs_;
  std::unique_ptr<FrameProcessor> processor_;

  CameraSubscription camera_;
  std::deque<WaitingFrame> waiting_;
  ros::Time last_stamp_;
  ros::Time last_now_;

  diagnostic_updater::Updater updater_;
  std::unique_ptr<ReconfigureServer> reconfigure_;
  ros::ServiceServer reset_;
  ros::WallTimer waiting_timer_;
  ros::WallTimer diagnostics_timer_;
};

}  // namespace polygonal_perception::ros_perception

#include "ros/perception/frame_processor.hpp"

#include <chrono>
#include <exception>

#include "polygonal_perception/perception/floor/floor_frame.hpp"
#include "polygonal_perception/ros/common/text_rules.hpp"
#include "ros/perception/cloud_input.hpp"
#include "ros/perception/floor_transforms.hpp"
#include "ros/perception/mount_error_text.hpp"

namespace polygonal_perception::ros_perception {

FrameProcessor::FrameProcessor(const PerceptionParameters& parameters, const std::string& info_topic,
                               const Outputs& outputs, ros_common::FrameStatistics& statistics,
                               ros_common::ThrottledLog& log)
    : parameters_(parameters),
      outputs_(outputs),
      statistics_(statistics),
      log_(log),
      pipeline_(parameters.pipeline),
      warnings_(log),
      depth_input_(info_topic),
      floor_frame_guard_(parameters.floor_frame)
{
  if (parameters.needsTf()) tf_ = std::make_unique<ros_common::TfBridge>();
}

bool FrameProcessor::process(const InputFrame& frame, bool may_wait)
{
  try {
    return processUnguarded(frame, may_wait);
  } catch (const std::exception& error) {
    resetFloor();
    reject("exception", std::string("the frame made the node fail: ") + error.what());
  } catch (...) {
    resetFloor();
    reject("exception", "the frame made the node fail for an unknown reason");
  }
  return true;
}

bool FrameProcessor::processUnguarded(const InputFrame& frame, bool may_wait)
{
  const std_msgs::Header& header = frame.header();
  if (frame.image && may_wait && depth_input_.awaitsCameraInfo(*frame.image)) return false;
  const ros_common::Expected<perception::PointView> points =
      frame.cloud ? viewCloud(*frame.cloud) : depth_input_.view(*frame.image, parameters_.depth_unit);
  if (!points) {
    reject("input", (frame.cloud ? "cloud rejected: " : "depth image rejected: ") + points.error());
    return true;
  }
  if (const std::string notice = depth_input_.takeNotice(); !notice.empty())
    log_.warn("distortion", ros_common::shortened(notice));
  if (const std::string error = frameError(header.frame_id); !error.empty()) {
    reject("input", error);
    return true;
  }
  // What would be placed in another camera's floor frame is not published at all.
  const bool owns_floor_frame = ownsFloorFrame(header.frame_id);
  if (!owns_floor_frame && !parameters_.hasOutputFrame()) return true;
  // Only now: a frame that is refused changes nothing, whatever its stamp.
  if (header.stamp < last_stamp_) resetTime("the frame's stamp is before the last one");
  last_stamp_ = header.stamp;
  followFrame(header.frame_id);
  const FrameTransforms transforms =
      lookUpTransforms(parameters_, tf_.get(), header, pipeline_.needsSeed(header.stamp.toSec()));
  if (may_wait && !transforms.missing().empty()) return false;

  runPipeline(header, *points, transforms);
  warnings_.update(pipeline_.result(), parameters_.pipeline.tracker.initial_up, parameters_.mount_frame,
                   header.stamp);
  const auto start = ros_common::FrameStatistics::Clock::now();
  // First, so that it is there when somebody places the rest by it.
  if (owns_floor_frame) broadcast(header);
  FrameResult result{header, *points, pipeline_.result(), pipeline_.parameters(), parameters_.floor_frame,
                     {}};
  if (transforms.missing_output.empty()) result.output = outputPose(transforms.input_to_output);
  outputs_.publish(result);
  if (transforms.missing().empty()) {
    statistics_.answered(pipeline_.result().times, ros_common::FrameStatistics::Clock::now() - start);
  } else {
    reject("tf", transforms.missing());
  }
  return true;
}

perception::Products FrameProcessor::neededProducts(const FrameTransforms& transforms) const
{
  // tf to the floor frame, and the diagnostics, want a floor in any case.
  const perception::Products needs = outputs_.needs() | perception::Product::kFloor;
  return transforms.missing_output.empty() ? needs : needs.withoutOutputFrame();
}

void FrameProcessor::runPipeline(const std_msgs::Header& header, const perception::PointView& points,
                                 const FrameTransforms& transforms)
{
  if (transforms.missing_input.empty()) {
    pipeline_.process({points, header.stamp.toSec(), transforms.hints, transforms.ignored},
                      neededProducts(transforms));
  } else {
    // Without the seed that was asked for there is no answer: initial_up may be far off. Nor is there one with the
    // robot's own parts among the obstacles.
    pipeline_.skip();
  }
}

std::string FrameProcessor::frameError(const std::string& frame_id) const
{
  if (std::string error = ros_common::frameIdError(frame_id); !error.empty()) return error;
  if (frame_id == parameters_.floor_frame) {
    return "header.frame_id is '" + frame_id + "', which is floor_frame; accepted is any other frame";
  }
  return {};
}

void FrameProcessor::followFrame(const std::string& frame_id)
{
  if (frame_id == input_frame_) return;
  if (!input_frame_.empty()) {
    log_.warn("frame_id", "header.frame_id has changed from '" + ros_common::shortened(input_frame_) +
                              "' to '" + ros_common::shortened(frame_id) + "': starting anew");
    resetFloor();
  }
  input_frame_ = frame_id;
}

OutputPose FrameProcessor::outputPose(const std::optional<Eigen::Isometry3d>& input_to_output) const
{
  if (!input_to_output) return {parameters_.floor_frame, Eigen::Isometry2d::Identity()};
  const perception::Pipeline::Result& result = pipeline_.result();
  Eigen::Isometry3d input_to_floor = result.to_floor_frame;
  if (result.floor.status == perception::FloorStatus::kNotFound) {
    // The unknown grid lies where the floor would be if tf were right about the camera's attitude.
    const geometry::Plane level{input_to_output->linear().row(2).transpose(), 0.0};
    input_to_floor = perception::floorFrame(level, result.heading);
  }
  return {parameters_.output_frame, poseInOutputFrame(*input_to_output, input_to_floor)};
}

bool FrameProcessor::ownsFloorFrame(const std::string& frame_id)
{
  if (!parameters_.publish_tf) return true;
  const std::string conflict = floor_frame_guard_.conflict(frame_id, FloorFrameGuard::Clock::now());
  if (!conflict.empty()) reject("floor_frame", conflict);
  return conflict.empty();
}

void FrameProcessor::broadcast(const std_msgs::Header& header)
{
  const perception::Pipeline::Result& result = pipeline_.result();
  if (!parameters_.publish_tf || result.floor.status == perception::FloorStatus::kNotFound) return;
  // tf2 complains of a transform that comes twice.
  if (header.stamp == last_broadcast_) return;
  last_broadcast_ = header.stamp;
  floor_frame_guard_.broadcast(header.frame_id);
  broadcaster_.sendTransform(toTransform(header, parameters_.floor_frame, result.to_floor_frame));
}

std::optional<CameraAttitude> FrameProcessor::attitude() const
{
  const perception::Pipeline::Result& result = pipeline_.result();
  if (result.floor.status == perception::FloorStatus::kNotFound) return std::nullopt;
  return cameraAttitude(result.floor.floor.plane.normal, result.view.forward,
                        parameters_.pipeline.tracker.initial_up);
}

std::string FrameProcessor::mountDisagreement() const
{
  const perception::Pipeline::Result& result = pipeline_.result();
  if (!result.floor.mount_error || !result.floor.mount_error->is_beyond) return {};
  return mountErrorText(result.floor, result.view.forward, parameters_.pipeline.tracker.initial_up,
                        parameters_.mount_frame);
}

void FrameProcessor::resetTime(const std::string& reason)
{
  log_.warn("time", "time has jumped back (" + reason + "): starting anew");
  statistics_.interrupt();
  last_stamp_ = ros::Time();
  resetFloor();
  if (tf_) tf_->clear();
  last_broadcast_ = ros::Time();
}

void FrameProcessor::reject(const char* kind, const std::string& reason)
{
  const std::string text = ros_common::shortened(reason);
  statistics_.rejected(text);
  log_.error(kind, text);
}

}  // namespace polygonal_perception::ros_perception

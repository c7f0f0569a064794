#include "polygonal_perception/ros/perception/perception_node.hpp"

#include <ros/service_server.h>
#include <ros/wall_timer.h>
#include <std_srvs/Trigger.h>

#include <deque>

#include "polygonal_perception/ros/common/diagnostics_reporter.hpp"
#include "polygonal_perception/ros/common/node_core.hpp"
#include "ros/perception/diagnostics.hpp"
#include "ros/perception/frame_processor.hpp"

namespace polygonal_perception::ros_perception {

namespace {

constexpr char kCameraInfo[] = "depth/camera_info";
constexpr double kWaitingPeriod = 0.004;  // [s] between two looks at the frames that wait
constexpr std::size_t kMostWaiting = 8;   // frames, which keep their publisher's memory

}  // namespace

class PerceptionNode::Implementation
{
public:
  Implementation(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle);
  ~Implementation() { core_.close(); }

private:
  struct WaitingFrame
  {
    InputFrame frame;
    ros_common::FrameStatistics::Clock::time_point arrival;
  };

  void makeMembers();
  void addInputs();
  void watchFloorFrame();
  void advertiseReset();
  ros_common::InputTopics::Unsubscribed followReaders();
  ros_common::InputTopics::Unsubscribed retrySubscription();
  void onFrame(const InputFrame& frame);
  void processWaiting();
  void dropWaiting();
  void checkClock();
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);
  void sayOtherType(const NodeState& state);

  ros_common::NodeCore<PerceptionParameters> core_;
  std::unique_ptr<Outputs> outputs_;
  std::unique_ptr<FrameProcessor> processor_;
  std::deque<WaitingFrame> waiting_;
  ros::Time last_now_;
  std::string said_other_type_;  // of the input, in the log
  ros::Subscriber tf_;           // of others who broadcast the floor frame
  ros::Subscriber static_tf_;
  ros::ServiceServer reset_;
  ros::WallTimer waiting_timer_;
  std::unique_ptr<ros_common::DiagnosticsReporter> diagnostics_;
};

PerceptionNode::Implementation::Implementation(const ros::NodeHandle& handle,
                                               const ros::NodeHandle& private_handle)
    : core_(handle, private_handle, ros_common::FrameStatistics::ofStages<perception::StageTimes>())
{
  core_.make([this] {
    makeMembers();
    return followReaders();
  });
}

void PerceptionNode::Implementation::makeMembers()
{
  outputs_ = std::make_unique<Outputs>(
      core_.private_handle, ros_common::unsubscribingOutside(core_.gate, [this] { return followReaders(); }));
  addOutputs(*outputs_);
  processor_ = std::make_unique<FrameProcessor>(*core_.parameters, core_.inputs.resolvedName(kCameraInfo),
                                                *outputs_, core_.statistics, core_.log);
  core_.parameters.serve(core_.gate, [this](const PerceptionParameters& parameters) {
    processor_->configure(parameters.pipeline);
  });
  addInputs();
  if (core_.parameters->publish_tf) watchFloorFrame();
  advertiseReset();
  constexpr bool kOneShot = false;
  constexpr bool kStarted = false;
  waiting_timer_ = core_.handle.createWallTimer(
      ros::WallDuration(kWaitingPeriod),
      ros_common::gated(core_.gate, [this](const ros::WallTimerEvent&) { processWaiting(); }), kOneShot,
      kStarted);
  diagnostics_ = std::make_unique<ros_common::DiagnosticsReporter>(
      core_.handle, core_.private_handle, core_.gate, core_.log, [this] { return retrySubscription(); },
      [this](auto& status) { diagnose(status); });
}

void PerceptionNode::Implementation::addInputs()
{
  if (core_.parameters->input == "depth") {
    core_.inputs.addImage("depth/image", core_.parameters->image_transport,
                          [this](const sensor_msgs::ImageConstPtr& image) {
                            onFrame({nullptr, image});
                          });
    core_.inputs.add<sensor_msgs::CameraInfo>(kCameraInfo,
                                              [this](const sensor_msgs::CameraInfoConstPtr& info) {
                                                processor_->setCameraInfo(info);
                                                processWaiting();
                                              });
  } else {
    core_.inputs.add<sensor_msgs::PointCloud2>("points",
                                               [this](const sensor_msgs::PointCloud2ConstPtr& cloud) {
                                                 onFrame({cloud, nullptr});
                                               });
  }
  core_.inputs.onChange(
      [this] {
        // A floor from before the pause may be one of another room.
        processor_->resetFloor();
        core_.statistics.interrupt();
      },
      [this] { dropWaiting(); });
}

void PerceptionNode::Implementation::watchFloorFrame()
{
  const auto subscribe = [this](const std::string& topic, bool is_static) {
    constexpr std::uint32_t kQueue = 100;
    using Event = ros::MessageEvent<const tf2_msgs::TFMessage>;
    const boost::function<void(const Event&)> see =
        ros_common::gated(core_.gate, [this, is_static](const Event& event) {
          processor_->floorFrameGuard().see(*event.getConstMessage(), event.getPublisherName(), is_static,
                                            FloorFrameGuard::Clock::now());
        });
    return core_.handle.subscribe<tf2_msgs::TFMessage>(topic, kQueue, see);
  };
  tf_ = subscribe("/tf", false);
  static_tf_ = subscribe("/tf_static", true);
}

void PerceptionNode::Implementation::advertiseReset()
{
  using std_srvs::Trigger;
  const boost::function<bool(Trigger::Request&, Trigger::Response&)> reset =
      [this, gate = core_.gate](Trigger::Request& /*request*/, Trigger::Response& response) {
        const auto inside = gate->enter();
        if (!inside.owns_lock()) return false;
        processor_->resetFloor();
        response.success = 1;
        response.message = "The floor is forgotten; the next frame starts from the seed.";
        return true;
      };
  reset_ = core_.private_handle.advertiseService("reset", reset);
}

ros_common::InputTopics::Unsubscribed PerceptionNode::Implementation::followReaders()
{
  return core_.setSubscribed(!core_.parameters->lazy || outputs_->hasReaders());
}

ros_common::InputTopics::Unsubscribed PerceptionNode::Implementation::retrySubscription()
{
  if (core_.inputs.error().empty()) return {};
  return followReaders();
}

void PerceptionNode::Implementation::onFrame(const InputFrame& frame)
{
  checkClock();
  const auto now = ros_common::FrameStatistics::Clock::now();
  core_.statistics.received(frame.header().seq, now);
  waiting_.push_back({frame, now});
  processWaiting();
}

void PerceptionNode::Implementation::processWaiting()
{
  const auto now = ros_common::FrameStatistics::Clock::now();
  while (!waiting_.empty()) {
    const double waited = std::chrono::duration<double>(now - waiting_.front().arrival).count();
    const bool may_wait = waited < core_.parameters->tf_timeout && waiting_.size() <= kMostWaiting;
    if (!processor_->process(waiting_.front().frame, may_wait)) break;
    waiting_.pop_front();
  }
  if (waiting_.empty()) {
    waiting_timer_.stop();
  } else {
    waiting_timer_.start();
  }
}

void PerceptionNode::Implementation::dropWaiting()
{
  waiting_timer_.stop();
  waiting_.clear();
}

void PerceptionNode::Implementation::checkClock()
{
  // Frames of the new time may come before its clock does: then the last stamp is not far ahead any more.
  constexpr double kClockLag = 1.0;  // [s]
  const ros::Time now = ros::Time::now();
  if (now < last_now_ && now.toSec() + kClockLag < processor_->lastStamp().toSec()) {
    processor_->resetTime("the clock was set back");
    core_.statistics.dropped(waiting_.size());
    waiting_.clear();
  }
  last_now_ = now;
}

void PerceptionNode::Implementation::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status)
{
  checkClock();
  NodeState state;
  state.active = core_.inputs.active();
  state.subscription_error = core_.inputs.error();
  state.awaited_topic = core_.inputs.topic();
  state.awaited_is_published = core_.inputs.isPublished();
  if (!state.awaited_is_published) state.awaited_other_type = core_.inputs.otherType();
  sayOtherType(state);
  if (state.active) {  // else the next frame will know nothing of the last floor
    state.floor = processor_->floor();
    state.heading = processor_->heading();
    state.attitude = processor_->attitude();
    state.mount_disagreement = processor_->mountDisagreement();
  }
  const auto now = ros_common::FrameStatistics::Clock::now();
  fillDiagnostics(state, core_.statistics, now, status);
  core_.statistics.startReport(now);
}

/// roscpp says nothing of a topic that it cannot read, and the publisher says it in a log of its own.
void PerceptionNode::Implementation::sayOtherType(const NodeState& state)
{
  if (state.awaited_other_type != said_other_type_ && !state.awaited_other_type.empty())
    core_.log.warn("type", "waiting for " + state.awaited_topic + publicationText(state));
  said_other_type_ = state.awaited_other_type;
}

PerceptionNode::PerceptionNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle)
    : implementation_(std::make_unique<Implementation>(handle, private_handle))
{
}
PerceptionNode::~PerceptionNode() = default;

std::string PerceptionNode::parameterTable()
{
  PerceptionParameters defaults;
  return ros_common::parameterTable(ros_common::listParameters(defaults));
}

}  // namespace polygonal_perception::ros_perception

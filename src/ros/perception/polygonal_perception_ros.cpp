#include "ros/perception/polygonal_perception_ros.hpp"

#include <ros/console.h>

#include <exception>
#include <vector>

#include "ros/common/diagnostic_period.hpp"
#include "ros/perception/diagnostics.hpp"
#include "ros/perception/topics.hpp"

namespace polygonal_perception::ros_perception {

namespace {

constexpr double kWaitingPeriod = 0.004;  // [s] between two looks at the frames that wait
constexpr std::size_t kMostWaiting = 8;   // frames, which keep their publisher's memory

NodeParameters readParameters(const ros::NodeHandle& private_handle)
{
  std::vector<std::string> errors;
  std::vector<std::string> warnings;
  NodeParameters parameters = readNodeParameters(private_handle, errors, warnings);
  for (const std::string& error : errors) ROS_ERROR_STREAM(error);
  for (const std::string& warning : warnings) ROS_WARN_STREAM(warning);
  ros_common::ensureDiagnosticPeriod(private_handle);
  return parameters;
}

/// A callback that runs `update` inside the gate and ends the subscriptions that are over outside of it.
template <class Update>
auto endingOutside(const std::shared_ptr<ros_common::CallbackGate>& gate, Update update)
{
  return [gate, update](const auto&...) {
    CameraSubscription::Ended ended;
    const auto inside = gate->enter();
    if (inside.owns_lock()) ended = update();
  };
}

}  // namespace

PolygonalPerceptionRos::PolygonalPerceptionRos(const ros::NodeHandle& handle,
                                               const ros::NodeHandle& private_handle)
    : handle_(handle),
      private_handle_(private_handle),
      name_(private_handle.getNamespace()),
      parameters_(readParameters(private_handle)),
      log_(name_),
      camera_(handle, name_, parameters_.input, gate_,
              {[this](const InputFrame& frame) { onFrame(frame); },
               [this](const sensor_msgs::CameraInfoConstPtr& info) { onCameraInfo(info); }}),
      updater_(handle, private_handle, name_)
{
  CameraSubscription::Ended ended;
  // Readers may come before everything stands: their callbacks wait outside.
  const auto inside = gate_->enter();
  outputs_ = std::make_unique<Outputs>(private_handle_,
                                       endingOutside(gate_, [this] { return updateSubscription(); }));
  processor_ = std::make_unique<FrameProcessor>(parameters_, handle_.resolveName(topics::kCameraInfo),
                                                *outputs_, statistics_, log_);
  reconfigure_ = std::make_unique<ReconfigureServer>(
      private_handle_, parameters_.pipeline,
      ros_common::gated(gate_, [this](const perception::Pipeline::Parameters& parameters) {
        processor_->configure(parameters);
      }));
  advertiseReset();
  startDiagnostics();
  constexpr bool kOneShot = false;
  constexpr bool kStarted = false;
  waiting_timer_ = handle_.createWallTimer(
      ros::WallDuration(kWaitingPeriod),
      ros_common::gated(gate_, [this](const ros::WallTimerEvent&) { processWaiting(); }), kOneShot, kStarted);
  ended = updateSubscription();
}

PolygonalPerceptionRos::~PolygonalPerceptionRos()
{
  gate_->close();
  reconfigure_->shutdown();
}

void PolygonalPerceptionRos::advertiseReset()
{
  using std_srvs::Trigger;
  const boost::function<bool(Trigger::Request&, Trigger::Response&)> reset =
      [this, gate = gate_](Trigger::Request& /*request*/, Trigger::Response& response) {
        const auto inside = gate->enter();
        if (!inside.owns_lock()) return false;
        processor_->forgetFloor();
        response.success = 1;
        response.message = "The floor is forgotten; the next frame starts from the seed.";
        return true;
      };
  reset_ = private_handle_.advertiseService(topics::kReset, reset);
}

void PolygonalPerceptionRos::startDiagnostics()
{
  updater_.setHardwareID("none");
  updater_.add("frames", this, &PolygonalPerceptionRos::diagnose);
  // By the wall clock: a bag that stands still is worth a report too. The updater may have read another
  // value, one that never ends, of a parameter that changes just now.
  diagnostics_timer_ =
      handle_.createWallTimer(ros::WallDuration(ros_common::ensureDiagnosticPeriod(private_handle_)),
                              endingOutside(gate_, [this] { return report(); }));
}

CameraSubscription::Ended PolygonalPerceptionRos::report()
{
  ros_common::ensureDiagnosticPeriod(private_handle_);
  CameraSubscription::Ended ended;
  if (!camera_.error().empty()) ended = updateSubscription();
  // It adds its period to the clock, which throws at the end of ROS's time.
  try {
    updater_.force_update();
  } catch (const std::exception& error) {
    log_.error("diagnostics", std::string("no diagnostics: ") + error.what());
  }
  return ended;
}

CameraSubscription::Ended PolygonalPerceptionRos::updateSubscription()
{
  const bool wanted = !parameters_.lazy || outputs_->hasReaders();
  if (!wanted) {
    waiting_timer_.stop();
    waiting_.clear();
    return camera_.stop();
  }
  if (camera_.active()) return {};
  // A floor from before the pause may be one of another room.
  processor_->forgetFloor();
  statistics_.interrupt();
  auto ended = camera_.start();
  if (!camera_.active()) log_.error("subscription", "cannot subscribe to " + camera_.error());
  return ended;
}

void PolygonalPerceptionRos::onCameraInfo(const sensor_msgs::CameraInfoConstPtr& info)
{
  processor_->setCameraInfo(info);
  processWaiting();
}

void PolygonalPerceptionRos::onFrame(const InputFrame& frame)
{
  checkClock();
  const std_msgs::Header& header = frame.header();
  if (header.stamp < last_stamp_) forgetTime("the frame's stamp is before the last one");
  last_stamp_ = header.stamp;

  const auto now = ros_common::FrameStatistics::Clock::now();
  statistics_.received(header.seq, now);
  waiting_.push_back({frame, now});
  processWaiting();
}

void PolygonalPerceptionRos::processWaiting()
{
  const auto now = ros_common::FrameStatistics::Clock::now();
  while (!waiting_.empty()) {
    const double waited = std::chrono::duration<double>(now - waiting_.front().arrival).count();
    const bool may_wait = waited < parameters_.tf_timeout && waiting_.size() <= kMostWaiting;
    if (!processor_->process(waiting_.front().frame, may_wait)) break;
    waiting_.pop_front();
  }
  if (waiting_.empty()) {
    waiting_timer_.stop();
  } else {
    waiting_timer_.start();
  }
}

void PolygonalPerceptionRos::checkClock()
{
  // Frames of the new time may come before its clock does: then last_stamp_ is not far ahead any more.
  constexpr double kClockLag = 1.0;  // [s]
  const ros::Time now = ros::Time::now();
  if (now < last_now_ && now.toSec() + kClockLag < last_stamp_.toSec()) forgetTime("the clock was set back");
  last_now_ = now;
}

void PolygonalPerceptionRos::forgetTime(const std::string& reason)
{
  log_.warn("time", "time has jumped back (" + reason + "): starting anew");
  processor_->forgetTime();
  statistics_.interrupt();
  statistics_.dropped(waiting_.size());
  waiting_.clear();
  last_stamp_ = ros::Time();
}

void PolygonalPerceptionRos::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status)
{
  checkClock();
  NodeState state;
  state.active = camera_.active();
  state.subscription_error = camera_.error();
  state.awaited_topic = camera_.topic();
  state.awaited_is_published = camera_.isPublished();
  if (camera_.active()) {  // else the next frame will know nothing of the last floor
    state.floor = processor_->floor();
    state.attitude = processor_->attitude();
  }
  const auto now = ros_common::FrameStatistics::Clock::now();
  fillDiagnostics(state, statistics_, now, status);
  statistics_.startReport(now);
}

}  // namespace polygonal_perception::ros_perception

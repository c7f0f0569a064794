#include "polygonal_perception/ros/polygonal_perception_ros.hpp"

#include <ros/console.h>
#include <ros/names.h>

#include <exception>
#include <stdexcept>
#include <vector>

#include "diagnostic_period.hpp"
#include "polygonal_perception/ros/diagnostics.hpp"
#include "polygonal_perception/ros/topics.hpp"

namespace polygonal_perception {

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
  ensureDiagnosticPeriod(private_handle);
  return parameters;
}

}  // namespace

PolygonalPerceptionRos::PolygonalPerceptionRos(const ros::NodeHandle& handle,
                                               const ros::NodeHandle& private_handle)
    : handle_(handle),
      private_handle_(private_handle),
      name_(private_handle.getNamespace()),
      parameters_(readParameters(private_handle)),
      log_(name_),
      updater_(handle, private_handle, name_)
{
  // Readers may come before everything stands: their callbacks wait outside.
  const auto inside = gate_->enter();
  outputs_ = std::make_unique<Outputs>(private_handle_, gated(gate_, [this] { updateSubscription(); }));
  processor_ = std::make_unique<FrameProcessor>(parameters_, handle_.resolveName(topics::kCameraInfo),
                                                *outputs_, statistics_, log_);
  reconfigure_ = std::make_unique<ReconfigureServer>(
      private_handle_, parameters_.pipeline,
      gated(gate_, [this](const Pipeline::Parameters& parameters) { processor_->configure(parameters); }));
  advertiseReset();
  startDiagnostics();
  constexpr bool kOneShot = false;
  constexpr bool kStarted = false;
  waiting_timer_ = handle_.createWallTimer(
      ros::WallDuration(kWaitingPeriod),
      gated(gate_, [this](const ros::WallTimerEvent&) { processWaiting(); }), kOneShot, kStarted);
  updateSubscription();
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
  // By the wall clock: a bag that stands still is worth a report too.
  diagnostics_timer_ =
      handle_.createWallTimer(ros::WallDuration(updater_.getPeriod()),
                              gated(gate_, [this](const ros::WallTimerEvent&) { report(); }));
}

void PolygonalPerceptionRos::report()
{
  ensureDiagnosticPeriod(private_handle_);
  if (!subscription_error_.empty()) updateSubscription();
  // It adds its period to the clock, which throws at the end of ROS's time.
  try {
    updater_.force_update();
  } catch (const std::exception& error) {
    log_.error("diagnostics", std::string("no diagnostics: ") + error.what());
  }
}

void PolygonalPerceptionRos::updateSubscription()
{
  const bool wanted = !parameters_.lazy || outputs_->hasReaders();
  subscription_error_.clear();
  if (!wanted && subscribed_) unsubscribe();
  if (!wanted || subscribed_) return;
  // roscpp throws where somebody in this process reads the same topic as another type; out of a callback that
  // would take the manager down.
  try {
    subscribe();
  } catch (const std::exception& error) {
    unsubscribe();
    subscription_error_ = error.what();
    log_.error("subscription", "cannot subscribe to " + subscription_error_);
  }
}

void PolygonalPerceptionRos::subscribe()
{
  // A floor from before the pause may be one of another room.
  processor_->forgetFloor();
  statistics_.interrupt();
  const auto subscribe = [this](auto message, const char* topic, auto action) {
    using Message = decltype(message);
    // In full: a nodelet of the root namespace in a manager of another one has a handle whose relative names
    // fall into the manager's namespace, past the nodelet's remappings.
    const std::string name = ros::names::append(ros::names::parentNamespace(name_), topic);
    try {
      return handle_.subscribe<Message>(name, topics::kInputQueueSize, gated(gate_, action), nullptr,
                                        ros::TransportHints().tcpNoDelay());
    } catch (const std::exception& error) {
      throw std::runtime_error(handle_.resolveName(name) + ": " + error.what());
    }
  };
  if (parameters_.input == "depth") {
    camera_info_ = subscribe(sensor_msgs::CameraInfo(), topics::kCameraInfo,
                             [this](const sensor_msgs::CameraInfoConstPtr& info) { onCameraInfo(info); });
    frames_ =
        subscribe(sensor_msgs::Image(), topics::kDepthImage, [this](const sensor_msgs::ImageConstPtr& image) {
          onFrame({nullptr, image});
        });
  } else {
    frames_ = subscribe(sensor_msgs::PointCloud2(), topics::kPoints,
                        [this](const sensor_msgs::PointCloud2ConstPtr& cloud) {
                          onFrame({cloud, nullptr});
                        });
  }
  subscribed_ = true;
}

void PolygonalPerceptionRos::unsubscribe()
{
  frames_.shutdown();
  camera_info_.shutdown();
  waiting_timer_.stop();
  waiting_.clear();
  subscribed_ = false;
}

void PolygonalPerceptionRos::onCameraInfo(const sensor_msgs::CameraInfoConstPtr& info)
{
  processor_->setCameraInfo(info);
  processWaiting();
}

bool PolygonalPerceptionRos::isRepeated(const InputFrame& frame)
{
  const auto message = frame.message();
  const bool repeated = !message.owner_before(last_message_) && !last_message_.owner_before(message);
  last_message_ = message;
  return repeated;
}

void PolygonalPerceptionRos::onFrame(const InputFrame& frame)
{
  // roscpp connects a publisher of the same process twice when it advertises while we subscribe, and then
  // hands over each message twice.
  if (isRepeated(frame)) return;
  checkClock();
  const std_msgs::Header& header = frame.header();
  if (header.stamp < last_stamp_) forgetTime("the frame's stamp is before the last one");
  last_stamp_ = header.stamp;

  const auto now = FrameStatistics::Clock::now();
  statistics_.received(header.seq, now);
  waiting_.push_back({frame, now});
  processWaiting();
}

void PolygonalPerceptionRos::processWaiting()
{
  const auto now = FrameStatistics::Clock::now();
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
  state.active = subscribed_;
  state.subscription_error = subscription_error_;
  state.awaited_topic = frames_.getTopic();
  state.awaited_is_published = frames_.getNumPublishers() > 0;
  if (subscribed_) {  // else the next frame will know nothing of the last floor
    state.floor = processor_->floor();
    state.attitude = processor_->attitude();
  }
  const auto now = FrameStatistics::Clock::now();
  fillDiagnostics(state, statistics_, now, status);
  statistics_.startReport(now);
}

}  // namespace polygonal_perception

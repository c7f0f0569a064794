#include "polygonal_perception/ros/driving/dynamic_window_node.hpp"

#include <geometry_msgs/Twist.h>
#include <ros/timer.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "polygonal_perception/ros/common/diagnostics_reporter.hpp"
#include "polygonal_perception/ros/common/node_core.hpp"
#include "ros/driving/drive_outputs.hpp"

namespace polygonal_perception::ros_driving {

namespace {

/// How long each stage of a command took.
struct DriveTimes
{
  std::chrono::nanoseconds decision{0};

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor&& visit)
  {
    visit("decision", self.decision);
  }
};

geometry_msgs::TwistPtr toMessage(const planning::Twist& twist)
{
  auto message = boost::make_shared<geometry_msgs::Twist>();
  message->linear.x = twist.x;
  message->linear.y = twist.y;
  message->angular.z = twist.theta;
  return message;
}

}  // namespace

class DynamicWindowNode::Implementation
{
public:
  Implementation(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle);
  ~Implementation() { core_.close(); }

private:
  using Clock = ros_common::FrameStatistics::Clock;

  void makeMembers();
  void addInputs();
  void tick();
  void scheduleNext(const ros::Time& now);
  void fillDiagnostics(ros_common::DiagnosticsReporter::Status& status);

  ros_common::NodeCore<DynamicWindowParameters> core_;
  std::unique_ptr<DriveOutputs> outputs_;
  std::unique_ptr<Driver> driver_;
  ros::Publisher command_;
  DriveReport last_;
  ros::Time last_now_;
  double due_ = 0.0;  // [s] the command that was made last
  ros::Timer timer_;
  std::unique_ptr<ros_common::DiagnosticsReporter> diagnostics_;
};

DynamicWindowNode::Implementation::Implementation(const ros::NodeHandle& handle,
                                                  const ros::NodeHandle& private_handle)
    : core_(handle, private_handle, ros_common::FrameStatistics::ofStages<DriveTimes>())
{
  core_.make([this] {
    makeMembers();
    return core_.setSubscribed(true);
  });
}

void DynamicWindowNode::Implementation::makeMembers()
{
  outputs_ = std::make_unique<DriveOutputs>(core_.private_handle, [] {});
  addOutputs(*outputs_);
  driver_ = std::make_unique<Driver>(*core_.parameters);
  core_.parameters.serve(core_.gate, [this](const DynamicWindowParameters& p) { driver_->configure(p); });
  addInputs();
  constexpr std::uint32_t kQueueSize = 1;
  command_ = core_.handle.advertise<geometry_msgs::Twist>(core_.inputs.resolvedName("cmd_vel"), kQueueSize);
  constexpr bool kOneShot = true;
  timer_ = core_.handle.createTimer(ros::Duration(1.0 / core_.parameters->control_frequency),
                                    ros_common::gated(core_.gate, [this](const ros::TimerEvent&) { tick(); }),
                                    kOneShot);
  diagnostics_ = std::make_unique<ros_common::DiagnosticsReporter>(
      core_.handle, core_.private_handle, core_.gate, core_.log, [this] { return core_.setSubscribed(true); },
      [this](auto& status) { fillDiagnostics(status); });
}

void DynamicWindowNode::Implementation::addInputs()
{
  core_.inputs.add<PolygonArray>("polygons", [this](const PolygonArrayConstPtr& polygons) {
    core_.statistics.received(polygons->header.seq, Clock::now());
    driver_->setPolygons(polygons);
  });
  core_.inputs.add<TrackedPolygonArray>(
      "tracked_polygons",
      [this](const TrackedPolygonArrayConstPtr& tracked) { driver_->setTracked(tracked); });
  core_.inputs.add<nav_msgs::Path>("path",
                                   [this](const nav_msgs::PathConstPtr& path) { driver_->setPath(path); });
  core_.inputs.add<nav_msgs::Odometry>(
      "odom", [this](const nav_msgs::OdometryConstPtr& odometry) { driver_->setOdometry(odometry); });
}

void DynamicWindowNode::Implementation::tick()
{
  const ros::Time now = ros::Time::now();
  if (now < last_now_) {
    core_.log.warn("time", "time has jumped back: everything is forgotten");
    driver_->reset();
  }
  last_now_ = now;
  scheduleNext(now);
  DriveTimes times;
  const auto begin = Clock::now();
  last_ = driver_->tick(now);
  times.decision = Clock::now() - begin;
  if (last_.is_refusal) {
    core_.statistics.rejected(last_.message);
    core_.log.error("input", last_.message);
  }
  command_.publish(toMessage(last_.command));
  outputs_->publish({last_, driver_->window()});
  core_.statistics.answered(times, Clock::now() - begin - times.decision);
}

void DynamicWindowNode::Implementation::scheduleNext(const ros::Time& now)
{
  // A clock that says 0.149999999 s means 0.15 s: a timer of roscpp's own would wait for the next tick.
  constexpr double kRounding = 1e-6;  // [s]
  const double period = 1.0 / core_.parameters->control_frequency;
  const bool keeps_time = std::abs(now.toSec() - due_) < 0.5 * period;
  due_ = (keeps_time ? due_ : now.toSec()) + period;
  timer_.stop();
  timer_.setPeriod(ros::Duration(std::max(kRounding, due_ - now.toSec() - kRounding)));
  timer_.start();
}

void DynamicWindowNode::Implementation::fillDiagnostics(ros_common::DiagnosticsReporter::Status& status)
{
  using diagnostic_msgs::DiagnosticStatus;
  const bool is_fine = last_.status == DriveStatus::DRIVING || last_.status == DriveStatus::ARRIVED ||
                       last_.status == DriveStatus::NO_PATH;
  status.summary(is_fine ? DiagnosticStatus::OK : DiagnosticStatus::WARN,
                 last_.message.empty() ? "no command yet" : last_.message);
  const auto now = Clock::now();
  status.addf("Input rate [Hz]", "%.1f", core_.statistics.rate(now));
  ros_common::addStatistics(core_.statistics, status);
  core_.statistics.startReport(now);
}

DynamicWindowNode::DynamicWindowNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle)
    : implementation_(std::make_unique<Implementation>(handle, private_handle))
{
}
DynamicWindowNode::~DynamicWindowNode() = default;

std::string DynamicWindowNode::parameterTable()
{
  DynamicWindowParameters defaults;
  return ros_common::parameterTable(ros_common::listParameters(defaults));
}

}  // namespace polygonal_perception::ros_driving

#include "polygonal_perception/ros/planning/shortest_path_node.hpp"

#include <geometry_msgs/PointStamped.h>
#include <nav_msgs/GetPlan.h>
#include <ros/service_server.h>
#include <ros/wall_timer.h>

#include <chrono>

#include "polygonal_perception/ros/common/diagnostics_reporter.hpp"
#include "polygonal_perception/ros/common/node_core.hpp"
#include "ros/planning/plan_maker.hpp"

namespace polygonal_perception::ros_planning {

namespace {

constexpr double kWaitingPeriod = 0.004;  // [s] between two looks at polygons that wait

}  // namespace

class ShortestPathNode::Implementation
{
public:
  Implementation(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle);
  ~Implementation() { core_.close(); }

private:
  using Clock = ros_common::FrameStatistics::Clock;

  void makeMembers();
  void onPolygons(const PolygonArrayConstPtr& polygons);
  void processWaiting(bool may_wait);
  void checkClock();
  void fillDiagnostics(ros_common::DiagnosticsReporter::Status& status);

  ros_common::NodeCore<ShortestPathParameters> core_;
  std::unique_ptr<PlanOutputs> outputs_;
  std::unique_ptr<PlanMaker> maker_;
  PolygonArrayConstPtr waiting_;
  Clock::time_point arrival_;  // of what waits
  ros::Time last_now_;
  ros::ServiceServer make_plan_;
  ros::WallTimer waiting_timer_;
  std::unique_ptr<ros_common::DiagnosticsReporter> diagnostics_;
};

ShortestPathNode::Implementation::Implementation(const ros::NodeHandle& handle,
                                                 const ros::NodeHandle& private_handle)
    : core_(handle, private_handle, ros_common::FrameStatistics::ofStages<PlanTimes>())
{
  core_.make([this] {
    makeMembers();
    return core_.setSubscribed(true);
  });
}

void ShortestPathNode::Implementation::makeMembers()
{
  outputs_ = std::make_unique<PlanOutputs>(core_.private_handle, [] {});
  addOutputs(*outputs_);
  maker_ = std::make_unique<PlanMaker>(*core_.parameters, *outputs_, core_.statistics, core_.log);
  core_.parameters.serve(core_.gate,
                         [this](const ShortestPathParameters& parameters) { maker_->configure(parameters); });
  core_.inputs.add<PolygonArray>("polygons",
                                 [this](const PolygonArrayConstPtr& polygons) { onPolygons(polygons); });
  core_.inputs.add<geometry_msgs::PoseStamped>(
      "goal", [this](const geometry_msgs::PoseStampedConstPtr& goal) { maker_->setGoal(*goal); });
  core_.inputs.add<geometry_msgs::PointStamped>("clicked_point",
                                                [this](const geometry_msgs::PointStampedConstPtr& point) {
                                                  geometry_msgs::PoseStamped goal;
                                                  goal.header = point->header;
                                                  goal.pose.position = point->point;
                                                  maker_->setGoal(goal);
                                                });

  using nav_msgs::GetPlan;
  const boost::function<bool(GetPlan::Request&, GetPlan::Response&)> serve =
      [this, gate = core_.gate](GetPlan::Request& request, GetPlan::Response& response) {
        const auto inside = gate->enter();
        if (!inside.owns_lock()) return false;
        response.plan = maker_->makePlan(request.start, request.goal, request.tolerance);
        return true;
      };
  make_plan_ = core_.private_handle.advertiseService("make_plan", serve);

  constexpr bool kOneShot = false;
  constexpr bool kStarted = false;
  waiting_timer_ = core_.handle.createWallTimer(
      ros::WallDuration(kWaitingPeriod),
      ros_common::gated(core_.gate, [this](const ros::WallTimerEvent&) { processWaiting(true); }), kOneShot,
      kStarted);
  diagnostics_ = std::make_unique<ros_common::DiagnosticsReporter>(
      core_.handle, core_.private_handle, core_.gate, core_.log, [this] { return core_.setSubscribed(true); },
      [this](auto& status) {
        checkClock();
        fillDiagnostics(status);
      });
}

void ShortestPathNode::Implementation::onPolygons(const PolygonArrayConstPtr& polygons)
{
  checkClock();
  // What waits for its transform is answered as it is: newer polygons are there.
  processWaiting(false);
  arrival_ = Clock::now();
  core_.statistics.received(polygons->header.seq, arrival_);
  waiting_ = polygons;
  processWaiting(true);
}

void ShortestPathNode::Implementation::processWaiting(bool may_wait)
{
  const double waited = std::chrono::duration<double>(Clock::now() - arrival_).count();
  if (waiting_ && maker_->process(waiting_, may_wait && waited < core_.parameters->tf_timeout))
    waiting_.reset();
  if (waiting_) {
    waiting_timer_.start();
  } else {
    waiting_timer_.stop();
  }
}

void ShortestPathNode::Implementation::checkClock()
{
  // Polygons of the new time may come before its clock does: then the newest stamp is not far ahead any more.
  constexpr double kClockLag = 1.0;  // [s]
  const ros::Time now = ros::Time::now();
  if (now < last_now_ && now.toSec() + kClockLag < maker_->newestStamp().toSec()) {
    maker_->resetTime("the clock was set back");
    waiting_.reset();
  }
  last_now_ = now;
}

void ShortestPathNode::Implementation::fillDiagnostics(ros_common::DiagnosticsReporter::Status& status)
{
  using diagnostic_msgs::DiagnosticStatus;
  const auto now = Clock::now();
  const ros_common::FrameStatistics& statistics = core_.statistics;
  status.summary(DiagnosticStatus::OK, "planning");
  if (statistics.silence(now) > 1.0) {
    status.summary(DiagnosticStatus::WARN, "no polygons come");
  } else if (statistics.recentlyReceived() > 0 &&
             statistics.recentlyRejected() >= statistics.recentlyReceived()) {
    status.summary(DiagnosticStatus::ERROR, "no plan can be made: " + statistics.lastRejection());
  }
  status.addf("Input rate [Hz]", "%.1f", statistics.rate(now));
  ros_common::addStatistics(statistics, status);
  core_.statistics.startReport(now);
}

ShortestPathNode::ShortestPathNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle)
    : implementation_(std::make_unique<Implementation>(handle, private_handle))
{
}
ShortestPathNode::~ShortestPathNode() = default;

std::string ShortestPathNode::parameterTable()
{
  ShortestPathParameters defaults;
  return ros_common::parameterTable(ros_common::listParameters(defaults));
}

}  // namespace polygonal_perception::ros_planning

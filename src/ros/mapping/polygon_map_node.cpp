#include "polygonal_perception/ros/mapping/polygon_map_node.hpp"

#include <polygonal_perception/MapFile.h>
#include <ros/service_server.h>
#include <ros/wall_timer.h>
#include <std_srvs/Empty.h>

#include <deque>
#include <vector>

#include "polygonal_perception/ros/common/diagnostics_reporter.hpp"
#include "polygonal_perception/ros/common/node_core.hpp"
#include "ros/mapping/map_diagnostics.hpp"
#include "ros/mapping/map_updater.hpp"

namespace polygonal_perception::ros_mapping {

namespace {

constexpr char kTopic[] = "observed_cells";
constexpr double kWaitingPeriod = 0.004;  // [s] between two looks at the observations that wait
constexpr std::size_t kMostWaiting = 16;

}  // namespace

class PolygonMapNode::Implementation
{
public:
  Implementation(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle);
  ~Implementation() { core_.close(); }

private:
  using Clock = ros_common::FrameStatistics::Clock;

  struct Waiting
  {
    std::size_t source;
    ObservedCellsConstPtr cells;
    Clock::time_point arrival;
  };

  void makeMembers();
  void addInputs();
  void advertiseClear();
  template <class Action>
  ros::ServiceServer advertiseFile(const char* name, Action action);
  void onCells(std::size_t source, const ObservedCellsConstPtr& cells);
  void processWaiting();
  void checkClock();

  ros_common::NodeCore<PolygonMapParameters> core_;
  std::unique_ptr<MapOutputs> outputs_;
  std::unique_ptr<MapUpdater> updater_;
  std::deque<Waiting> waiting_;
  std::vector<bool> is_held_up_;  // by source
  ros::Time last_now_;
  ros::ServiceServer clear_;
  ros::ServiceServer save_;
  ros::ServiceServer load_;
  ros::WallTimer waiting_timer_;
  std::unique_ptr<ros_common::DiagnosticsReporter> diagnostics_;
};

PolygonMapNode::Implementation::Implementation(const ros::NodeHandle& handle,
                                               const ros::NodeHandle& private_handle)
    : core_(handle, private_handle, ros_common::FrameStatistics::ofStages<mapping::PolygonMap::StageTimes>())
{
  core_.make([this] {
    makeMembers();
    return core_.setSubscribed(true);
  });
}

void PolygonMapNode::Implementation::makeMembers()
{
  outputs_ = std::make_unique<MapOutputs>(core_.private_handle, [] {});
  addOutputs(*outputs_);
  const std::vector<std::string>& sources = core_.parameters->sources;
  updater_ = std::make_unique<MapUpdater>(*core_.parameters,
                                          sources.empty() ? std::vector<std::string>{kTopic} : sources,
                                          *outputs_, core_.statistics, core_.log);
  core_.parameters.serve(core_.gate,
                         [this](const PolygonMapParameters& parameters) { updater_->configure(parameters); });
  addInputs();
  advertiseClear();
  save_ = advertiseFile("save", [this](const std::string& path) { return updater_->save(path); });
  load_ = advertiseFile("load", [this](const std::string& path) { return updater_->load(path); });
  constexpr bool kOneShot = false;
  constexpr bool kStarted = false;
  waiting_timer_ = core_.handle.createWallTimer(
      ros::WallDuration(kWaitingPeriod),
      ros_common::gated(core_.gate, [this](const ros::WallTimerEvent&) { processWaiting(); }), kOneShot,
      kStarted);
  diagnostics_ = std::make_unique<ros_common::DiagnosticsReporter>(
      core_.handle, core_.private_handle, core_.gate, core_.log, [this] { return core_.setSubscribed(true); },
      [this](auto& status) {
        checkClock();
        const auto now = Clock::now();
        fillDiagnostics(updater_->sources(), core_.statistics, now, status);
        core_.statistics.startReport(now);
      });
}

void PolygonMapNode::Implementation::addInputs()
{
  const std::vector<std::string>& sources = core_.parameters->sources;
  for (std::size_t k = 0; k < std::max<std::size_t>(1, sources.size()); ++k) {
    const std::string topic = sources.empty() ? kTopic : sources[k] + "/" + kTopic;
    core_.inputs.add<ObservedCells>(topic.c_str(),
                                    [this, k](const ObservedCellsConstPtr& cells) { onCells(k, cells); });
  }
}

void PolygonMapNode::Implementation::advertiseClear()
{
  using std_srvs::Empty;
  const boost::function<bool(Empty::Request&, Empty::Response&)> clear =
      [this, gate = core_.gate](Empty::Request& /*request*/, Empty::Response& /*response*/) {
        const auto inside = gate->enter();
        if (!inside.owns_lock()) return false;
        updater_->clear();
        return true;
      };
  clear_ = core_.private_handle.advertiseService("clear", clear);
}

template <class Action>
ros::ServiceServer PolygonMapNode::Implementation::advertiseFile(const char* name, Action action)
{
  const boost::function<bool(MapFile::Request&, MapFile::Response&)> serve =
      [gate = core_.gate, action](MapFile::Request& request, MapFile::Response& response) {
        const auto inside = gate->enter();
        if (!inside.owns_lock()) return false;
        const ros_common::Expected<std::string> done = action(request.path);
        response.success = done ? 1 : 0;
        response.message = done ? *done : done.error();
        return true;
      };
  return core_.private_handle.advertiseService(name, serve);
}

void PolygonMapNode::Implementation::onCells(std::size_t source, const ObservedCellsConstPtr& cells)
{
  checkClock();
  const auto now = Clock::now();
  core_.statistics.received(cells->header.seq, now);
  waiting_.push_back({source, cells, now});
  processWaiting();
}

void PolygonMapNode::Implementation::processWaiting()
{
  const auto now = Clock::now();
  is_held_up_.assign(updater_->sources().size(), false);
  for (auto next = waiting_.begin(); next != waiting_.end();) {
    // What a source has sent is taken in its order; nobody waits for the transforms of another one.
    const double waited = std::chrono::duration<double>(now - next->arrival).count();
    const bool may_wait = waited < core_.parameters->tf_timeout && waiting_.size() <= kMostWaiting;
    if (is_held_up_[next->source] || !updater_->process(next->source, *next->cells, may_wait)) {
      is_held_up_[next->source] = true;
      ++next;
    } else {
      next = waiting_.erase(next);
    }
  }
  if (waiting_.empty()) {
    waiting_timer_.stop();
  } else {
    waiting_timer_.start();
  }
}

void PolygonMapNode::Implementation::checkClock()
{
  // Observations of the new time may come before its clock does: then the newest stamp is not far ahead any more.
  constexpr double kClockLag = 1.0;  // [s]
  const ros::Time now = ros::Time::now();
  if (now < last_now_ && now.toSec() + kClockLag < updater_->newestStamp().toSec()) {
    updater_->resetTime("the clock was set back");
    core_.statistics.dropped(waiting_.size());
    waiting_.clear();
  }
  last_now_ = now;
}

PolygonMapNode::PolygonMapNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle)
    : implementation_(std::make_unique<Implementation>(handle, private_handle))
{
}
PolygonMapNode::~PolygonMapNode() = default;

std::string PolygonMapNode::parameterTable()
{
  PolygonMapParameters defaults;
  return ros_common::parameterTable(ros_common::listParameters(defaults));
}

}  // namespace polygonal_perception::ros_mapping

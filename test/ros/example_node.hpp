#pragma once

#include <polygonal_perception/FloorPlane.h>
#include <polygonal_perception/PolygonArray.h>
#include <std_msgs/UInt32.h>

#include <chrono>
#include <memory>
#include <optional>

#include "polygonal_perception/ros/common/diagnostics_reporter.hpp"
#include "polygonal_perception/ros/common/node_core.hpp"
#include "polygonal_perception/ros/common/output_table.hpp"

namespace polygonal_perception::test {

/// What a node of this package takes: it counts the obstacles with at least so many corners. Lazy,
/// reconfigurable, with diagnostics and a clean end.
class ExampleNode
{
public:
  struct Parameters
  {
    int min_corners = 3;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit)
    {
      visit("min_corners", self.min_corners, parameters::Range{3, 100}, "",
            "Obstacles with fewer do not count.");
    }
    std::optional<parameters::ParameterFault> conflict() const { return std::nullopt; }
  };

  struct StageTimes
  {
    std::chrono::nanoseconds counting{0};

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit)
    {
      visit("counting", self.counting);
    }
  };

  ExampleNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle)
      : core_(handle, private_handle, ros_common::FrameStatistics::ofStages<StageTimes>())
  {
    core_.make([this] {
      outputs_ = std::make_unique<Outputs>(
          core_.private_handle,
          ros_common::unsubscribingOutside(core_.gate, [this] { return followReaders(); }));
      outputs_->add<std_msgs::UInt32>("count", {}, [](const std::uint32_t& count) {
        auto message = boost::make_shared<std_msgs::UInt32>();
        message->data = count;
        return message;
      });
      core_.inputs.add<PolygonArray>("polygons",
                                     [this](const PolygonArrayConstPtr& array) { onPolygons(*array); });
      core_.parameters.serve(core_.gate, [](const Parameters&) {});
      diagnostics_ = std::make_unique<ros_common::DiagnosticsReporter>(
          core_.handle, core_.private_handle, core_.gate, core_.log, [this] { return followReaders(); },
          [this](auto& status) {
            status.summary(diagnostic_msgs::DiagnosticStatus::OK,
                           core_.inputs.active() ? "counting" : "idle");
            ros_common::addStatistics(core_.statistics, status);
          });
      return followReaders();
    });
  }
  ~ExampleNode() { core_.close(); }

private:
  struct Nothing
  {
    Nothing& operator|=(Nothing) { return *this; }
  };
  using Outputs = ros_common::OutputTable<std::uint32_t, Nothing>;

  ros_common::InputTopics::Unsubscribed followReaders()
  {
    return core_.setSubscribed(outputs_->hasReaders());
  }

  void onPolygons(const PolygonArray& array)
  {
    const auto start = std::chrono::steady_clock::now();
    core_.statistics.received(array.header.seq, start);
    if (array.floor_status == FloorPlane::NOT_FOUND) {
      core_.statistics.rejected("floor_status is NOT_FOUND, accepted are FOUND and HELD");
      core_.log.error("floor", core_.statistics.lastRejection());
      return;
    }
    std::uint32_t count = 0;
    for (const ObstaclePolygon& polygon : array.polygons) {
      count += static_cast<int>(polygon.boundary.points.size()) >= core_.parameters->min_corners ? 1 : 0;
    }
    const auto counted = std::chrono::steady_clock::now();
    outputs_->publish(count);
    core_.statistics.answered(StageTimes{counted - start}, std::chrono::steady_clock::now() - counted);
  }

  ros_common::NodeCore<Parameters> core_;
  std::unique_ptr<Outputs> outputs_;
  std::unique_ptr<ros_common::DiagnosticsReporter> diagnostics_;
};

}  // namespace polygonal_perception::test

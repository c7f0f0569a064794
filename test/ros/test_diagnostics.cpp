#include <gtest/gtest.h>

#include <map>

#include "polygonal_perception/perception/stage_times.hpp"
#include "ros/perception/diagnostics.hpp"

namespace polygonal_perception::ros_perception {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using std::chrono::milliseconds;

class DiagnosticsTest : public testing::Test
{
protected:
  DiagnosticsTest()
  {
    statistics_.startReport(start_);
    state_.active = true;
    state_.awaited_topic = "/camera/points";
    state_.awaited_is_published = true;
  }

  DiagnosticStatus report(milliseconds after)
  {
    diagnostic_updater::DiagnosticStatusWrapper status;
    fillDiagnostics(state_, statistics_, start_ + after, status);
    for (const auto& value : status.values) values_[value.key] = value.value;
    return status;
  }

  ros_common::FrameStatistics::Clock::time_point start_ = ros_common::FrameStatistics::Clock::now();
  NodeState state_;
  ros_common::FrameStatistics statistics_ = ros_common::FrameStatistics::ofStages<perception::StageTimes>();
  std::map<std::string, std::string> values_;
};

TEST_F(DiagnosticsTest, IdleIsOkHoweverLong)
{
  state_.active = false;
  const DiagnosticStatus status = report(milliseconds(60000));
  EXPECT_EQ(status.level, DiagnosticStatus::OK);
  EXPECT_EQ(status.message, "idle: nobody reads an output");
}

TEST_F(DiagnosticsTest, WhatKeepsItFromSubscribingIsAnError)
{
  state_.active = false;
  state_.subscription_error = "/camera/points: another type";
  const DiagnosticStatus status = report(milliseconds(0));
  EXPECT_EQ(status.level, DiagnosticStatus::ERROR);
  EXPECT_EQ(status.message, "cannot subscribe to /camera/points: another type");
}

TEST_F(DiagnosticsTest, SilenceIsAnErrorThatNamesTheTopic)
{
  statistics_.received(1, start_);
  const DiagnosticStatus status = report(milliseconds(2500));
  EXPECT_EQ(status.level, DiagnosticStatus::ERROR);
  EXPECT_EQ(status.message, "no frame for 2.5 s: waiting for /camera/points");
  state_.awaited_is_published = false;
  EXPECT_EQ(report(milliseconds(2500)).message,
            "no frame for 2.5 s: waiting for /camera/points, which nobody publishes");
  state_.awaited_other_type = "sensor_msgs/CompressedImage";
  EXPECT_EQ(report(milliseconds(2500)).message,
            "no frame for 2.5 s: waiting for /camera/points, which is published as "
            "sensor_msgs/CompressedImage: not "
            "what this node reads");
}

TEST_F(DiagnosticsTest, CountsRateAndTimes)
{
  perception::StageTimes times;
  times.samples = milliseconds(1);
  times.floor = milliseconds(2);
  for (int i = 0; i < 10; ++i) {
    // Two were lost on the way, between the fifth and the sixth.
    statistics_.received(static_cast<std::uint32_t>(i < 5 ? 100 + i : 102 + i),
                         start_ + milliseconds(100 * i));
    statistics_.answered(times, milliseconds(i == 9 ? 6 : 1));
  }
  statistics_.dropped(1);
  state_.floor.status = perception::FloorStatus::kFound;
  state_.floor.floor.plane.distance = 1.25;
  state_.attitude = CameraAttitude{0.5, -0.1};
  state_.heading = {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ(),
                    perception::ViewAxes::Source::kParameter};
  const DiagnosticStatus status = report(milliseconds(1000));
  EXPECT_EQ(status.level, DiagnosticStatus::OK);
  EXPECT_EQ(status.message, "floor found");
  EXPECT_EQ(values_["Input rate [Hz]"], "10.0");
  EXPECT_EQ(values_["Frames answered"], "10");
  EXPECT_EQ(values_["Frames rejected"], "0");
  EXPECT_EQ(values_["Frames dropped"], "3");
  EXPECT_EQ(values_["Camera height [m]"], "1.250");
  EXPECT_EQ(values_["Ahead"], "(1, 0, 0): the parameter forward");
  EXPECT_EQ(values_["Camera pitch [deg]"], "28.65");
  EXPECT_EQ(values_["Camera roll [deg]"], "-5.73");
  EXPECT_EQ(values_["Time of samples mean [ms]"], "1.000");
  EXPECT_EQ(values_["Time of floor max [ms]"], "2.000");
  EXPECT_EQ(values_["Time of messages mean [ms]"], "1.500");
  EXPECT_EQ(values_["Time of messages max [ms]"], "6.000");
  EXPECT_EQ(values_["Time of polygons mean [ms]"], "0.000") << "a stage that nobody asked for";
  EXPECT_EQ(values_["Time of total mean [ms]"], "4.500");

  statistics_.startReport(start_ + milliseconds(1000));
  statistics_.received(112, start_ + milliseconds(1500));
  report(milliseconds(2000));
  EXPECT_EQ(values_["Input rate [Hz]"], "1.0");
  EXPECT_EQ(values_["Frames answered"], "10") << "counts go on";
  EXPECT_EQ(values_["Time of total mean [ms]"], "0.000") << "times begin anew";
}

TEST_F(DiagnosticsTest, NoFloorIsAWarningAndAHeldOneIsNot)
{
  statistics_.received(1, start_);
  EXPECT_EQ(report(milliseconds(100)).level, DiagnosticStatus::WARN);
  state_.floor.status = perception::FloorStatus::kHeld;
  state_.floor.age = 0.3;
  const DiagnosticStatus status = report(milliseconds(100));
  EXPECT_EQ(status.level, DiagnosticStatus::OK);
  EXPECT_EQ(status.message, "floor held for 0.30 s");
}

TEST_F(DiagnosticsTest, RejectedFramesAreAnErrorWhenAllAre)
{
  state_.floor.status = perception::FloorStatus::kFound;
  statistics_.received(1, start_);
  statistics_.rejected("field 'x' is missing");
  const DiagnosticStatus status = report(milliseconds(100));
  EXPECT_EQ(status.level, DiagnosticStatus::ERROR);
  EXPECT_EQ(status.message, "every frame is rejected: field 'x' is missing");
  statistics_.received(2, start_);
  EXPECT_EQ(report(milliseconds(100)).level, DiagnosticStatus::OK);
  EXPECT_EQ(values_["Frames rejected"], "1");
  EXPECT_EQ(values_["Last rejection"], "field 'x' is missing");
}

TEST_F(DiagnosticsTest, APublisherThatDoesNotCountOrStartsAgainDropsNothing)
{
  for (const std::uint32_t sequence : {7U, 8U, 3U, 4U, 0U, 0U, 90U}) statistics_.received(sequence, start_);
  EXPECT_EQ(statistics_.droppedCount(), 0U);
  statistics_.interrupt();
  statistics_.received(95, start_);
  EXPECT_EQ(statistics_.droppedCount(), 0U) << "frames that nobody wanted are not dropped";
  statistics_.received(97, start_);
  EXPECT_EQ(statistics_.droppedCount(), 1U) << "the publisher after the interruption may count";
}

TEST_F(DiagnosticsTest, TheGapAfterThePublishersFirstFrameIsCounted)
{
  for (const std::uint32_t sequence : {0U, 26U}) statistics_.received(sequence, start_);
  EXPECT_EQ(statistics_.droppedCount(), 25U);
}

}  // namespace
}  // namespace polygonal_perception::ros_perception

// Frames that come faster than they can be answered, or twice: the newest is answered, once, and the others
// are dropped and counted.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <nodelet/loader.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "clouds.hpp"
#include "observations.hpp"
#include "polygonal_perception/PolygonArray.h"

namespace polygonal_perception::test {
namespace {

const ros::WallDuration kDeadline(30.0);  // on a busy machine
constexpr std::uint32_t kBurst = 500;     // frames, at once

using sensor_msgs::PointCloud2;

template <class Message>
boost::shared_ptr<Message> frameOf(const ros::Time& stamp);
template <>
sensor_msgs::PointCloud2Ptr frameOf<PointCloud2>(const ros::Time& stamp)
{
  return floorCloud(stamp);
}
template <>
ObservedCellsPtr frameOf<ObservedCells>(const ros::Time& stamp)
{
  return observedCells(stamp);
}

/// Plays frames to a node and listens to it.
class Overload : public testing::Test
{
protected:
  void listenTo(const std::string& node)
  {
    polygons_ = handle_.subscribe<PolygonArray>(
        node + "/polygons", 2 * kBurst,
        [this](const PolygonArrayConstPtr& polygons) { answers_.push_back(polygons->header.stamp); });
    diagnostics_ = handle_.subscribe<diagnostic_msgs::DiagnosticArray>(
        "/diagnostics", 100, [this, node](const diagnostic_msgs::DiagnosticArrayConstPtr& report) {
          for (const auto& status : report->status) {
            if (status.name == node.substr(1) + ": frames") last_report_ = status;
          }
        });
  }

  template <class Condition>
  bool waitFor(Condition&& condition)
  {
    const ros::WallTime end = ros::WallTime::now() + kDeadline;
    while (!condition()) {
      if (ros::WallTime::now() > end) return false;
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.02));
    }
    return true;
  }

  /// The next frame, a millisecond later than the last one.
  template <class Message>
  boost::shared_ptr<const Message> nextFrame()
  {
    stamp_ += ros::Duration(0.001);
    const boost::shared_ptr<Message> frame = frameOf<Message>(stamp_);
    frame->header.seq = ++played_;
    return frame;
  }

  std::uint64_t reported(const std::string& key) const
  {
    for (const auto& value : last_report_.values) {
      if (value.key == key) return std::stoull(value.value);
    }
    return 0;
  }

  template <class Message>
  void expectTheNewestAnsweredAndTheOthersCounted(const std::string& topic)
  {
    const ros::Publisher camera = handle_.advertise<Message>(topic, 1);
    ASSERT_TRUE(waitFor([&] {
      return camera.getNumSubscribers() > 0 && polygons_.getNumPublishers() > 0 &&
             diagnostics_.getNumPublishers() > 0;
    })) << "connections";
    // What was lost before the first frame that arrives, nobody can know.
    camera.publish(nextFrame<Message>());
    ASSERT_TRUE(waitFor([this] { return !answers_.empty(); })) << "no answer to a single frame";

    std::vector<boost::shared_ptr<const Message>> burst(kBurst);
    std::generate(burst.begin(), burst.end(), [this] { return nextFrame<Message>(); });
    for (const auto& frame : burst) camera.publish(frame);
    ASSERT_TRUE(waitFor([this] { return answers_.back() == stamp_; }))
        << "the newest frame is not answered: " << answers_.size() << " answers, the last to "
        << answers_.back() << " of " << stamp_;
    EXPECT_TRUE(std::is_sorted(answers_.begin(), answers_.end()));
    EXPECT_EQ(std::adjacent_find(answers_.begin(), answers_.end()), answers_.end())
        << "a frame was answered twice";

    EXPECT_TRUE(waitFor([this] {
      return reported("Frames answered") + reported("Frames dropped") == played_;
    })) << "of "
        << played_ << " frames " << reported("Frames answered") << " answered, " << reported("Frames dropped")
        << " dropped and " << reported("Frames rejected") << " rejected";
    EXPECT_GT(reported("Frames dropped"), 0U) << "a burst that was none";
    EXPECT_EQ(reported("Frames rejected"), 0U);
  }

  ros::NodeHandle handle_;
  ros::Subscriber polygons_;
  ros::Subscriber diagnostics_;
  ros::Time stamp_ = ros::Time::now();
  std::uint32_t played_ = 0;
  std::vector<ros::Time> answers_;
  diagnostic_msgs::DiagnosticStatus last_report_;
};

TEST_F(Overload, OfANodeInAnotherProcess)
{
  listenTo("/elsewhere");
  expectTheNewestAnsweredAndTheOthersCounted<PointCloud2>("/points_of_elsewhere");
}

TEST_F(Overload, OfAMapInAnotherProcess)
{
  const ros::Publisher places = handle_.advertise<tf2_msgs::TFMessage>("/tf_static", 1, true);
  places.publish(inOdom("base_link", stamp_));
  listenTo("/map_elsewhere");
  expectTheNewestAnsweredAndTheOthersCounted<ObservedCells>("/cells_of_elsewhere");
}

TEST_F(Overload, OfAMapBesideItsSensor)
{
  const ros::Publisher places = handle_.advertise<tf2_msgs::TFMessage>("/tf_static", 1, true);
  places.publish(inOdom("base_link", stamp_));
  nodelet::Loader manager;
  const std::string name = "/map_of_same_process";
  ASSERT_TRUE(manager.load(name, "polygonal_perception/PolygonMap",
                           {{"/observed_cells", "/cells_of_same_process"}}, {}));
  listenTo(name);
  expectTheNewestAnsweredAndTheOthersCounted<ObservedCells>("/cells_of_same_process");
}

TEST_F(Overload, OfANodeletBesideItsCamera)
{
  nodelet::Loader manager;
  const std::string name = "/same_process";
  ASSERT_TRUE(manager.load(name, "polygonal_perception/PolygonalPerception",
                           {{"/points", "/points_of_same_process"}}, {}));
  listenTo(name);
  expectTheNewestAnsweredAndTheOthersCounted<PointCloud2>("/points_of_same_process");
}

TEST_F(Overload, OfOneMessageThatComesTwice)
{
  nodelet::Loader manager;
  const std::string name = "/repeated";
  ASSERT_TRUE(
      manager.load(name, "polygonal_perception/PolygonalPerception", {{"/points", "/repeated_points"}}, {}));
  listenTo(name);
  const ros::Publisher camera = handle_.advertise<sensor_msgs::PointCloud2>("/repeated_points", 1);
  ASSERT_TRUE(waitFor([&] { return camera.getNumSubscribers() > 0 && polygons_.getNumPublishers() > 0; }));
  for (std::size_t k = 1; k <= 5; ++k) {
    const auto frame = nextFrame<PointCloud2>();
    camera.publish(frame);
    ASSERT_TRUE(waitFor([&] { return answers_.size() >= k; })) << "no answer to frame " << k;
    camera.publish(frame);
  }
  const auto end = nextFrame<PointCloud2>();
  camera.publish(end);
  ASSERT_TRUE(waitFor([&] { return answers_.back() == end->header.stamp; }));
  EXPECT_EQ(answers_.size(), 6U);
}

}  // namespace
}  // namespace polygonal_perception::test

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "overload");
  const ros::NodeHandle keeps_ros_up;
  return RUN_ALL_TESTS();
}

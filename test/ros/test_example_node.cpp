// The kit that every node stands on, by way of a node that has nothing else: ExampleNode, in a nodelet.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <dynamic_reconfigure/Reconfigure.h>
#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <functional>
#include <map>
#include <string>

#include "example_node.hpp"
#include "polygonal_perception/ros/common/nodelet_of.hpp"

namespace polygonal_perception::test {
namespace {

/// Serves all callbacks until the condition holds, or for 10 s.
bool waitFor(const std::function<bool()>& condition)
{
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(10.0);
  while (!condition() && ros::WallTime::now() < deadline) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
  }
  return condition();
}

PolygonArray arrayWith(std::initializer_list<std::size_t> corners)
{
  PolygonArray array;
  array.floor_status = FloorPlane::FOUND;
  for (const std::size_t count : corners) {
    array.polygons.emplace_back();
    array.polygons.back().boundary.points.resize(count);
  }
  return array;
}

class ExampleNodelet : public testing::Test
{
protected:
  ExampleNodelet()
  {
    handle_.setParam("/example/min_corners", 4);
    handle_.setParam("/example/diagnostic_period", 0.1);
    nodelet_.init("/example", {}, {}, ros::getGlobalCallbackQueue(), ros::getGlobalCallbackQueue());
  }

  void read()
  {
    reader_ = handle_.subscribe<std_msgs::UInt32>(
        "/example/count", 5, [this](const std_msgs::UInt32ConstPtr& m) { count_ = m->data; });
  }

  /// Publishes until the node has answered.
  bool countsTo(const PolygonArray& array, std::uint32_t expected)
  {
    count_ = kNone;
    if (!waitFor([this] { return source_.getNumSubscribers() > 0; })) return false;
    source_.publish(array);
    const bool same = waitFor([&] { return count_ == expected; });
    EXPECT_EQ(count_, expected);
    return same;
  }

  /// The node's next report.
  std::map<std::string, std::string> report()
  {
    std::map<std::string, std::string> values;
    const boost::function<void(const diagnostic_msgs::DiagnosticArrayConstPtr&)> keep =
        [&values](const diagnostic_msgs::DiagnosticArrayConstPtr& array) {
          for (const auto& value : array->status.at(0).values) values[value.key] = value.value;
          values["message"] = array->status.at(0).message;
        };
    const ros::Subscriber reader =
        handle_.subscribe<diagnostic_msgs::DiagnosticArray>("/diagnostics", 1, keep);
    EXPECT_TRUE(waitFor([&values] { return !values.empty(); })) << "no report came";
    return values;
  }

  static constexpr std::uint32_t kNone = 999;
  ros::NodeHandle handle_;
  ros::Publisher source_ = handle_.advertise<PolygonArray>("/polygons", 1);
  ros_common::NodeletOf<ExampleNode> nodelet_;
  ros::Subscriber reader_;
  std::uint32_t count_ = kNone;
};

TEST_F(ExampleNodelet, SubscribesOnlyWhileItsOutputIsRead)
{
  EXPECT_EQ(report()["message"], "idle");
  EXPECT_EQ(source_.getNumSubscribers(), 0U);
  read();
  EXPECT_TRUE(waitFor([this] { return source_.getNumSubscribers() == 1; })) << "it has not subscribed";
  reader_.shutdown();
  EXPECT_TRUE(waitFor([this] { return source_.getNumSubscribers() == 0; })) << "it is still subscribed";
}

TEST_F(ExampleNodelet, AnswersByTheParametersInForce)
{
  read();
  EXPECT_TRUE(countsTo(arrayWith({3, 4, 5}), 2)) << "min_corners is 4 on the server";
}

TEST_F(ExampleNodelet, TakesAGoodSetAndRefusesABadOne)
{
  read();
  const auto set = [](int value) {
    dynamic_reconfigure::Reconfigure call;
    call.request.config.ints.resize(1);
    call.request.config.ints[0].name = "min_corners";
    call.request.config.ints[0].value = value;
    ros::AsyncSpinner spinner(1);
    spinner.start();
    EXPECT_TRUE(ros::service::call("/example/set_parameters", call));
    return call.response.config.ints.at(0).value;
  };
  EXPECT_EQ(set(5), 5);
  EXPECT_TRUE(countsTo(arrayWith({3, 4, 5}), 1));
  EXPECT_EQ(set(2), 5) << "2 is out of range: 5 stays";
  EXPECT_TRUE(countsTo(arrayWith({3, 4, 5}), 1));
}

TEST_F(ExampleNodelet, CountsWhatItAnswersAndRefusesAndTimesItsStages)
{
  read();
  ASSERT_TRUE(countsTo(arrayWith({4}), 1));
  PolygonArray without_floor;
  source_.publish(without_floor);
  std::map<std::string, std::string> values;
  EXPECT_TRUE(waitFor([&] { return (values = report())["Frames rejected"] == "1"; }));
  EXPECT_EQ(values["Frames answered"], "1");
  EXPECT_EQ(values["Last rejection"], "floor_status is NOT_FOUND, accepted are FOUND and HELD");
  EXPECT_EQ(values.count("Time of counting mean [ms]"), 1U);
  EXPECT_EQ(values.count("Time of total max [ms]"), 1U);
}

}  // namespace
}  // namespace polygonal_perception::test

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_example_node");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}

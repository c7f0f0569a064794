// Stamps and clocks that stand still, jump, run ahead or are not there: each frame is answered for its own
// stamp, and nothing of another time is taken for new.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "clouds.hpp"
#include "polygonal_perception/FloorPlane.h"
#include "polygonal_perception/PolygonArray.h"
#include "polygonal_perception/ros/perception/perception_node.hpp"

namespace polygonal_perception::test {
namespace {

const ros::WallDuration kDeadline(30.0);  // on a busy machine

/// A node and its reader, in a namespace of its own a test and on one queue that the test serves.
class TimeTest : public testing::Test
{
protected:
  void TearDown() override
  {
    node_.reset();
    ros::Time::setNow(ros::Time());
  }

  void start()
  {
    handle_.setCallbackQueue(&queue_);
    private_handle_.setCallbackQueue(&queue_);
    private_handle_.setParam("diagnostic_period", 0.02);
    clouds_ = handle_.advertise<sensor_msgs::PointCloud2>("points", 1);
    diagnostics_ = handle_.subscribe("/diagnostics", 100, &TimeTest::onDiagnostics, this);
    transforms_ = handle_.subscribe("/tf", 100, &TimeTest::onTransform, this);
    floors_ = private_handle_.subscribe("floor", 100, &TimeTest::onFloor, this);
    polygons_ = private_handle_.subscribe("polygons", 100, &TimeTest::onPolygons, this);
    node_ = std::make_unique<ros_perception::PerceptionNode>(handle_, private_handle_);
    waitFor("the connections", [this] {
      return clouds_.getNumSubscribers() > 0 && floors_.getNumPublishers() > 0 &&
             polygons_.getNumPublishers() > 0 && diagnostics_.getNumPublishers() > 0 &&
             transforms_.getNumPublishers() > 0;
    });
  }

  template <class Condition>
  void waitFor(const char* what, Condition&& condition)
  {
    const ros::WallTime end = ros::WallTime::now() + kDeadline;
    while (!condition()) {
      ASSERT_LT(ros::WallTime::now(), end) << "waited in vain for " << what;
      queue_.callAvailable(ros::WallDuration(0.02));
    }
  }

  /// The floor as it was published for a frame; also checks that there is one answer, and of the frame's
  /// stamp.
  FloorPlane ask(const sensor_msgs::PointCloud2ConstPtr& cloud)
  {
    const std::size_t before = floor_answers_.size();
    clouds_.publish(cloud);
    waitFor("an answer", [&] { return floor_answers_.size() > before; });
    if (HasFatalFailure()) return {};
    EXPECT_EQ(floor_answers_.size(), before + 1) << "answers to one frame";
    EXPECT_EQ(floor_answers_.back().header.stamp, cloud->header.stamp);
    return floor_answers_.back();
  }

  int see(double stamp) { return ask(floorCloud(ros::Time(stamp))).status; }
  int seeNothing(double stamp) { return ask(wallCloud(ros::Time(stamp))).status; }

  /// The node is alive: its next report comes.
  void expectReports()
  {
    const std::size_t before = reports_;
    waitFor("two reports", [&] { return reports_ > before + 1; });
  }

  void onFloor(const FloorPlane& floor) { floor_answers_.push_back(floor); }
  void onPolygons(const PolygonArray& polygons) { polygon_answers_.push_back(polygons); }
  void onTransform(const tf2_msgs::TFMessage& message)
  {
    for (const auto& transform : message.transforms) transform_stamps_.push_back(transform.header.stamp);
  }
  void onDiagnostics(const diagnostic_msgs::DiagnosticArray& report)
  {
    ++reports_;
    for (const auto& status : report.status) {
      for (const auto& entry : status.values) {
        if (entry.key == "Frames rejected") rejected_ = std::stoul(entry.value);
      }
    }
  }

  /// Shows a frame that is refused.
  void seeRefused(const sensor_msgs::PointCloud2ConstPtr& cloud)
  {
    const std::size_t answers = floor_answers_.size();
    const unsigned long before = rejected_;
    clouds_.publish(cloud);
    waitFor("the frame to be refused", [&] { return rejected_ > before; });
    EXPECT_EQ(floor_answers_.size(), answers) << "a refused frame was answered";
  }

  ros::CallbackQueue queue_;
  ros::NodeHandle handle_{std::string("/") + testing::UnitTest::GetInstance()->current_test_info()->name()};
  ros::NodeHandle private_handle_{handle_, "perception"};
  ros::Publisher clouds_;
  ros::Subscriber diagnostics_;
  ros::Subscriber transforms_;
  ros::Subscriber floors_;
  ros::Subscriber polygons_;
  std::vector<FloorPlane> floor_answers_;
  std::vector<PolygonArray> polygon_answers_;
  std::vector<ros::Time> transform_stamps_;
  std::size_t reports_ = 0;
  unsigned long rejected_ = 0;  // frames, as reported
  std::unique_ptr<ros_perception::PerceptionNode> node_;
};

TEST_F(TimeTest, WithoutAClockFramesAreAnsweredByTheirOwnStamps)
{
  ASSERT_TRUE(ros::Time::isSimTime());
  ASSERT_TRUE(ros::Time::now().isZero()) << "use_sim_time, and no clock";
  start();
  EXPECT_EQ(see(100.0), FloorPlane::FOUND);
  EXPECT_EQ(seeNothing(100.1), FloorPlane::HELD);
  EXPECT_EQ(see(100.2), FloorPlane::FOUND);
  expectReports();
}

TEST_F(TimeTest, AFrameWithoutAStampIsAnsweredAndNothingIsHeld)
{
  start();
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(see(0.0), FloorPlane::FOUND);
    EXPECT_EQ(seeNothing(0.0), FloorPlane::NOT_FOUND) << "how old would it be?";
  }
  EXPECT_EQ(see(50.0), FloorPlane::FOUND);
  EXPECT_EQ(see(0.0), FloorPlane::FOUND);
  EXPECT_EQ(see(50.1), FloorPlane::FOUND);
  waitFor("transforms", [this] { return transform_stamps_.size() >= 2; });
  EXPECT_EQ(transform_stamps_, (std::vector<ros::Time>{ros::Time(50.0), ros::Time(50.1)}))
      << "tf takes 0 for the latest";
}

TEST_F(TimeTest, AFrameWithoutAStampHasNoPlaceInAnotherFrame)
{
  private_handle_.setParam("output_frame", "odom");
  start();
  EXPECT_EQ(see(0.0), FloorPlane::FOUND);
  queue_.callAvailable();
  EXPECT_TRUE(polygon_answers_.empty()) << "placed by a transform of any age";
}

TEST_F(TimeTest, EqualStampsAreAnsweredEachAndNothingIsHeld)
{
  start();
  EXPECT_EQ(see(50.0), FloorPlane::FOUND);
  EXPECT_EQ(see(50.0), FloorPlane::FOUND);
  EXPECT_EQ(seeNothing(50.0), FloorPlane::NOT_FOUND);
  EXPECT_EQ(see(50.1), FloorPlane::FOUND);
}

TEST_F(TimeTest, AnOlderStampStartsAnew)
{
  start();
  EXPECT_EQ(see(50.0), FloorPlane::FOUND);
  EXPECT_EQ(seeNothing(49.9), FloorPlane::NOT_FOUND) << "the floor of 50.0 is not known at 49.9";
  EXPECT_EQ(seeNothing(50.1), FloorPlane::NOT_FOUND) << "nor is it after that";
  EXPECT_EQ(see(50.2), FloorPlane::FOUND);
}

TEST_F(TimeTest, ARefusedFrameChangesNothingWhateverItsStamp)
{
  start();
  for (const double stamp : {1.0, 49.9, 50.05, 4e9}) {
    EXPECT_EQ(see(50.0), FloorPlane::FOUND);
    const sensor_msgs::PointCloud2Ptr short_of_data = floorCloud(ros::Time(stamp));
    short_of_data->data.resize(100);
    seeRefused(short_of_data);
    seeRefused(floorCloud(ros::Time(stamp), "/with_a_slash"));
    const FloorPlane held = ask(wallCloud(ros::Time(50.1)));
    EXPECT_EQ(held.status, FloorPlane::HELD) << "after a refused frame of " << stamp;
    EXPECT_NEAR(held.age, 0.1, 1e-6);
  }
}

TEST_F(TimeTest, AStampFarInTheFutureDoesNotBlockTheNextOnes)
{
  ros::Time::setNow(ros::Time(50.0));
  start();
  EXPECT_EQ(see(50.0), FloorPlane::FOUND);
  EXPECT_EQ(seeNothing(5e8), FloorPlane::NOT_FOUND);
  EXPECT_EQ(see(5e8 + 0.1), FloorPlane::FOUND);
  EXPECT_EQ(seeNothing(50.1), FloorPlane::NOT_FOUND);
  EXPECT_EQ(see(50.2), FloorPlane::FOUND);
}

TEST_F(TimeTest, ABagThatLoopsIsAnsweredInEachRound)
{
  start();
  constexpr int kFrames = 10;
  for (int round = 0; round < 3; ++round) {
    ros::Time::setNow(ros::Time(1000.0));
    EXPECT_EQ(seeNothing(1000.0), FloorPlane::NOT_FOUND) << "the floor of the last round is forgotten";
    for (int k = 1; k < kFrames; ++k) {
      ros::Time::setNow(ros::Time(1000.0 + 0.1 * k));
      EXPECT_EQ(see(1000.0 + 0.1 * k), FloorPlane::FOUND) << "round " << round << " frame " << k;
    }
  }
}

TEST_F(TimeTest, AClockThatJumpsAheadEndsWhatWasHeld)
{
  ros::Time::setNow(ros::Time(10.0));
  start();
  EXPECT_EQ(see(10.0), FloorPlane::FOUND);
  ros::Time::setNow(ros::Time(1000.0));
  EXPECT_EQ(seeNothing(1000.0), FloorPlane::NOT_FOUND);
  EXPECT_EQ(see(1000.1), FloorPlane::FOUND);
}

TEST_F(TimeTest, AClockThatIsSetBackForgetsBeforeAFrameComes)
{
  ros::Time::setNow(ros::Time(1000.0));
  start();
  EXPECT_EQ(see(1000.0), FloorPlane::FOUND);
  expectReports();
  ros::Time::setNow(ros::Time(10.0));
  expectReports();
  EXPECT_EQ(seeNothing(1000.1), FloorPlane::NOT_FOUND);
  EXPECT_EQ(see(10.1), FloorPlane::FOUND);
}

TEST_F(TimeTest, TheEndOfRosTimeIsSurvived)
{
  const ros::Time last(std::numeric_limits<std::uint32_t>::max(), 999999999);
  start();
  // The time of the next report cannot be told.
  ros::Time::setNow(last);
  EXPECT_EQ(ask(floorCloud(last)).status, FloorPlane::FOUND);
  // Set back, but not by more than a clock may lag, which is past the end.
  ros::Time::setNow(last - ros::Duration(0.5));
  EXPECT_EQ(ask(floorCloud(last)).status, FloorPlane::FOUND);
  ros::Time::setNow(ros::Time(10.0));
  EXPECT_EQ(see(10.0), FloorPlane::FOUND);
  expectReports();
}

TEST_F(TimeTest, NoDiagnosticPeriodTakesTheNodeDown)
{
  start();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const double period : {kNan, kInfinity, -kInfinity, 1e300, -1.0, 0.0}) {
    private_handle_.setParam("diagnostic_period", period);
    expectReports();
    const ros::NodeHandle other(handle_, "other");
    other.setParam("diagnostic_period", period);
    EXPECT_NO_THROW(ros_perception::PerceptionNode(handle_, other)) << period;
    EXPECT_EQ(other.param("diagnostic_period", 0.0), 1.0) << "in the place of " << period;
  }
}

/// roscpp caches a parameter in the process, and roscore tells it late of a change.
TEST_F(TimeTest, ACachedDiagnosticPeriodTakesNoNodeDown)
{
  const ros::NodeHandle other(handle_, "cached");
  double cached = 0.0;
  other.setParam("diagnostic_period", 1e300);
  ASSERT_TRUE(other.getParamCached("diagnostic_period", cached));
  ASSERT_EQ(cached, 1e300);
  // As another process does it: this one's cache knows nothing of it until roscore's news arrives.
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue payload;
  request[0] = "/another_process";
  request[1] = other.resolveName("diagnostic_period");
  request[2] = 0.5;
  ASSERT_TRUE(ros::master::execute("setParam", request, response, payload, true));
  EXPECT_NO_THROW(ros_perception::PerceptionNode(handle_, other));
}

}  // namespace
}  // namespace polygonal_perception::test

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_time");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}

// What the map allocates for an observation once it is warm: nothing in the core, what tf takes, and its messages.
#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include "observations.hpp"
#include "polygonal_perception/PolygonArray.h"
#include "ros/mapping/map_updater.hpp"
#include "support/allocation_counter.hpp"

namespace polygonal_perception::test {
namespace {

class MapAllocations : public testing::Test
{
protected:
  void SetUp() override
  {
    if (!AllocationCounter::available()) GTEST_SKIP() << "a sanitizer counts allocations itself";
  }

  /// Another one each time: something stands anywhere, in a grid that lies anywhere.
  ObservedCellsPtr nextCells()
  {
    const ObservedCellsPtr cells = observedCells(stamp_ += ros::Duration(0.033));
    ++count_;
    for (std::size_t k = 0; k < cells->hit.size(); ++k)
      cells->hit[k] = (k * 7 + k / 40 * 3 + count_) % 97 == 0 ? 0x3C : 0;
    cells->info.origin.position.x = 0.02 * static_cast<double>(count_ % 50);
    cells->info.origin.orientation.z = std::sin(0.05 * static_cast<double>(count_ % 60));
    cells->info.origin.orientation.w = std::cos(0.05 * static_cast<double>(count_ % 60));
    return cells;
  }

  ros::Time stamp_ = ros::Time::now();
  std::size_t count_ = 0;
};

TEST_F(MapAllocations, OfTheCoreAreNoneOnceItIsWarm)
{
  mapping::PolygonMap::Parameters parameters;
  parameters.map.remember = 5.0;
  ros_mapping::MapIntake intake(parameters, {"front"});
  mapping::PolygonMap::Products products;
  products.polygons = products.seen = true;
  // The robot drives in a circle: each round shows the same.
  constexpr int kRound = 300;
  std::size_t warm = 0;
  std::size_t warming = 0;
  for (int k = 0; k < 4 * kRound; ++k) {
    const ObservedCellsPtr cells = nextCells();
    ros_mapping::MapIntake::Placement placement{Eigen::Isometry3d::Identity(), Eigen::Isometry3d::Identity()};
    const double angle = 2.0 * M_PI * k / kRound;
    placement.robot_to_fixed.translation() << 3.0 * std::cos(angle), 3.0 * std::sin(angle), 0.0;
    *placement.grid_to_fixed = placement.robot_to_fixed;
    const AllocationCounter counter;
    const auto admission = intake.admit(0, *cells);
    ASSERT_EQ(admission.fault, nullptr) << admission.reason;
    intake.take(0, *cells, placement, 0.3);
    ASSERT_FALSE(intake.map().make(products).polygons.rings.empty());
    (k < 3 * kRound ? warming : warm) += counter.count();
  }
  EXPECT_GT(warming, 0U);
  EXPECT_EQ(warm, 0U);
}

/// The node's part of it, with a robot that stands.
class NodeAllocations : public MapAllocations
{
protected:
  NodeAllocations()
  {
    ros_mapping::addOutputs(outputs_);
    places_ = node_.advertise<tf2_msgs::TFMessage>("/tf_static", 1, true);
    places_.publish(inOdom("base_link", stamp_));
  }

  /// Of the updater for the last of some observations.
  std::size_t ofAnObservation()
  {
    std::size_t count = 0;
    const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(20.0);
    for (int answered = 0; answered < 50 && ros::WallTime::now() < deadline;) {
      const ObservedCellsPtr cells = observedCells(stamp_ += ros::Duration(0.033));
      const std::uint64_t before = statistics_.answeredCount();
      const AllocationCounter counter;
      updater_.process(0, *cells, true);
      count = counter.count();
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.001));
      answered += statistics_.answeredCount() > before ? 1 : 0;  // until tf is there none is
    }
    EXPECT_GE(statistics_.answeredCount(), 50U) << statistics_.lastRejection();
    return count;
  }

  ros::NodeHandle node_{"~"};
  ros::Publisher places_;
  ros_mapping::PolygonMapParameters parameters_;
  ros_mapping::MapOutputs outputs_{node_, [] {}};
  ros_common::FrameStatistics statistics_ =
      ros_common::FrameStatistics::ofStages<mapping::PolygonMap::StageTimes>();
  ros_common::ThrottledLog log_{"test"};
  ros_mapping::MapUpdater updater_{parameters_, {"front"}, outputs_, statistics_, log_};
};

TEST_F(NodeAllocations, AreThoseOfTfWithoutReaders)
{
  const std::size_t count = ofAnObservation();
  const ros_common::TfBridge tf;
  std::size_t of_tf = 0;
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(20.0);
  for (bool found = false; !found && ros::WallTime::now() < deadline;) {
    const std::string from = "base_link", to = "odom";
    const AllocationCounter counter;
    found = static_cast<bool>(tf.lookup(to, from, stamp_));
    of_tf = counter.count();
  }
  EXPECT_LE(count, of_tf);
}

TEST_F(NodeAllocations, AreThePolygonsBesideWithAReaderOfThem)
{
  const std::size_t without = ofAnObservation();
  PolygonArrayConstPtr polygons;
  const boost::function<void(const PolygonArrayConstPtr&)> keep = [&](const PolygonArrayConstPtr& p) {
    polygons = p;
  };
  const ros::Subscriber reader = node_.subscribe<PolygonArray>("polygons", 5, keep);
  const std::size_t with = ofAnObservation();
  ASSERT_TRUE(polygons);
  ASSERT_EQ(polygons->polygons.size(), 1U);

  // The same message again, made and published without a node around it.
  const boost::function<void(const PolygonArrayConstPtr&)> ignore = [](const PolygonArrayConstPtr&) {};
  const ros::Publisher publisher = node_.advertise<PolygonArray>("control", 1);
  const ros::Subscriber control_reader = node_.subscribe<PolygonArray>("control", 5, ignore);
  std::size_t control = 0;
  for (int k = 0; k < 10; ++k) {
    const AllocationCounter counter;
    publisher.publish(boost::make_shared<PolygonArray>(*polygons));
    control = counter.count();
    ros::getGlobalCallbackQueue()->callAvailable();
  }
  EXPECT_EQ(with, without + control);
}

}  // namespace
}  // namespace polygonal_perception::test

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "map_allocations");
  const ros::NodeHandle keeps_ros_up;
  return RUN_ALL_TESTS();
}

// In one nodelet manager the map reads the very cells that a sensor's nodelet publishes, as in test_zero_copy.cpp: they come
// without anything in them, and get their obstacle while they wait for their transform.
#include <gtest/gtest.h>
#include <nodelet/loader.h>
#include <ros/ros.h>

#include "counting_publisher.hpp"
#include "observations.hpp"
#include "polygonal_perception/PolygonArray.h"

namespace polygonal_perception::test {
namespace {

TEST(ZeroCopy, TheCellsThatArePublishedAreThoseThatTheMapReads)
{
  CountingPublisher<ObservedCells> sensor("/observed_cells");
  ros::NodeHandle node;
  const ros::Publisher transforms = node.advertise<tf2_msgs::TFMessage>("/tf", 1);
  PolygonArrayConstPtr answer;
  const ros::Subscriber reader = node.subscribe<PolygonArray>(
      "/map/polygons", 1, [&](const PolygonArrayConstPtr& polygons) { answer = polygons; });
  nodelet::Loader manager;
  ASSERT_TRUE(manager.load("/map", "polygonal_perception/PolygonMap", {}, {}));
  ASSERT_TRUE(waitFor([&] {
    return sensor.readers() == 1 && transforms.getNumSubscribers() == 1 && reader.getNumPublishers() == 1;
  })) << sensor.readers()
      << " readers of the cells, " << transforms.getNumSubscribers() << " of /tf";

  const ros::Time stamp = ros::Time::now();
  const ObservedCellsPtr cells = observedCells(stamp);
  const std::vector<std::uint8_t> hit = cells->hit;
  cells->hit.assign(hit.size(), 0);
  sensor.publish(cells);
  EXPECT_GT(cells.use_count(), 1) << "the cells are not held where they were published";
  cells->hit = hit;
  transforms.publish(inOdom("base_link", stamp));
  ASSERT_TRUE(waitFor([&] { return answer != nullptr; })) << "no answer";
  EXPECT_EQ(answer->header.stamp, stamp);
  EXPECT_EQ(answer->polygons.size(), 1U) << "the obstacle that came after the publishing was not seen";
  EXPECT_EQ(sensor.serialisations(), 0);
  EXPECT_TRUE(waitFor([&] { return cells.use_count() == 1; })) << "the answered cells are still held";
}

}  // namespace
}  // namespace polygonal_perception::test

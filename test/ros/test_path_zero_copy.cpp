// In one nodelet manager the planner reads the very polygons that are published, as in test_map_zero_copy.cpp: they come
// without an obstacle, and get it while they wait for the robot's transform.
#include <geometry_msgs/PoseStamped.h>
#include <gtest/gtest.h>
#include <nav_msgs/Path.h>
#include <nodelet/loader.h>
#include <ros/ros.h>

#include "counting_publisher.hpp"
#include "observations.hpp"

namespace polygonal_perception::test {
namespace {

TEST(ZeroCopy, ThePolygonsThatArePublishedAreThoseThatArePlannedOn)
{
  CountingPublisher<PolygonArray> map("/polygons");
  ros::NodeHandle node;
  const ros::Publisher transforms = node.advertise<tf2_msgs::TFMessage>("/tf", 1);
  const ros::Publisher goals = node.advertise<geometry_msgs::PoseStamped>("/goal", 1);
  nav_msgs::PathConstPtr answer;
  const ros::Subscriber reader = node.subscribe<nav_msgs::Path>(
      "/paths/path", 1, [&](const nav_msgs::PathConstPtr& path) { answer = path; });
  nodelet::Loader manager;
  ASSERT_TRUE(manager.load("/paths", "polygonal_perception/ShortestPath", {}, {}));
  ASSERT_TRUE(waitFor([&] {
    return map.readers() == 1 && transforms.getNumSubscribers() == 1 && goals.getNumSubscribers() == 1 &&
           reader.getNumPublishers() == 1;
  })) << map.readers()
      << " readers of the polygons, " << transforms.getNumSubscribers() << " of /tf";

  geometry_msgs::PoseStamped goal;
  goal.header.frame_id = "odom";
  goal.pose.position.x = 3.0;
  goals.publish(goal);
  // Until the goal is there: it comes by a queue of its own.
  ASSERT_TRUE(waitFor([&] {
    const ros::Time stamp = ros::Time::now();
    transforms.publish(inOdom("base_link", stamp));
    map.publish(boxAhead(stamp));
    return answer != nullptr && !answer->poses.empty();
  })) << "no path";
  const int serialisations = map.serialisations();

  const ros::Time stamp = ros::Time::now() + ros::Duration(1.0);
  const PolygonArrayPtr polygons = boxAhead(stamp);
  std::vector<ObstaclePolygon> obstacles;
  obstacles.swap(polygons->polygons);
  map.publish(polygons);
  ASSERT_TRUE(waitFor([&] { return polygons.use_count() > 1; }))
      << "the polygons are not held where they were published";
  obstacles.swap(polygons->polygons);
  transforms.publish(inOdom("base_link", stamp));
  ASSERT_TRUE(waitFor([&] { return answer->header.stamp == stamp; })) << "no answer";
  EXPECT_EQ(answer->poses.size(), 4U) << "the obstacle that came after the publishing was not seen";
  EXPECT_EQ(map.serialisations(), serialisations);
}

}  // namespace
}  // namespace polygonal_perception::test

// Nodes that are taken down while frames, readers and calls arrive from all sides, as when nodelets are unloaded.
#include <dynamic_reconfigure/Reconfigure.h>
#include <geometry_msgs/PoseStamped.h>
#include <gtest/gtest.h>
#include <nav_msgs/GetPlan.h>
#include <nav_msgs/Path.h>
#include <polygonal_perception/MapFile.h>
#include <polygonal_perception/PolygonArray.h>
#include <ros/ros.h>
#include <std_srvs/Empty.h>
#include <std_srvs/Trigger.h>

#include "clouds.hpp"
#include "lives.hpp"
#include "observations.hpp"
#include "polygonal_perception/ros/mapping/polygon_map_node.hpp"
#include "polygonal_perception/ros/perception/perception_node.hpp"
#include "polygonal_perception/ros/planning/shortest_path_node.hpp"

namespace polygonal_perception::test {
namespace {

/// Of each node, unless ~lives says otherwise.
int lives()
{
  return ros::param::param("~lives", 40);
}

template <class Service>
void call(const std::string& name)
{
  Service service;
  ros::service::call(name, service);
}

TEST(Lifecycle, OfPerceptionIsClean)
{
  ros::NodeHandle handle;
  const ros::Publisher clouds = handle.advertise<sensor_msgs::PointCloud2>("points", 1);
  const Traffic<PolygonArray> traffic(
      "perception/polygons", [&] { clouds.publish(floorCloud(ros::Time::now())); },
      [] {
        call<std_srvs::Trigger>("perception/reset");
        call<dynamic_reconfigure::Reconfigure>("perception/set_parameters");
      });
  expectCleanLives<ros_perception::PerceptionNode>(
      "perception", lives(), traffic, [](int life) { ros::param::set("perception/lazy", life % 2 == 0); });
}

TEST(Lifecycle, OfTheMapIsClean)
{
  ros::NodeHandle handle;
  const ros::Publisher cells = handle.advertise<ObservedCells>("observed_cells", 1);
  const ros::Publisher places = handle.advertise<tf2_msgs::TFMessage>("/tf_static", 1, true);
  places.publish(inOdom("base_link", ros::Time::now()));
  int sent = 0;
  const Traffic<PolygonArray> traffic(
      "map/polygons",
      [&] {
        // Each third one has no transform, so that something waits at any time.
        cells.publish(observedCells(ros::Time::now(), ++sent % 3 == 0 ? "nowhere" : "odom"));
      },
      [] {
        call<std_srvs::Empty>("map/clear");
        call<MapFile>("map/save");
        call<MapFile>("map/load");
        call<dynamic_reconfigure::Reconfigure>("map/set_parameters");
      });
  expectCleanLives<ros_mapping::PolygonMapNode>(
      "map", lives(), traffic, [](int life) { ros::param::set("map/map_size", life % 2 == 0 ? 4.0 : 12.0); });
}

TEST(Lifecycle, OfTheShortestPathIsClean)
{
  ros::NodeHandle handle;
  const ros::Publisher polygons = handle.advertise<PolygonArray>("polygons", 1);
  const ros::Publisher goals = handle.advertise<geometry_msgs::PoseStamped>("goal", 1, true);
  const ros::Publisher places = handle.advertise<tf2_msgs::TFMessage>("/tf_static", 1, true);
  places.publish(inOdom("base_link", ros::Time::now()));
  geometry_msgs::PoseStamped goal;
  goal.header.frame_id = "odom";
  goal.pose.position.x = 3.0;
  goals.publish(goal);
  int sent = 0;
  const Traffic<nav_msgs::Path> traffic(
      "paths/path",
      [&] {
        // Each third one has no transform, so that something waits at any time.
        polygons.publish(boxAhead(ros::Time::now(), ++sent % 3 == 0 ? "nowhere" : "odom"));
      },
      [] {
        call<nav_msgs::GetPlan>("paths/make_plan");
        call<dynamic_reconfigure::Reconfigure>("paths/set_parameters");
      });
  expectCleanLives<ros_planning::ShortestPathNode>("paths", lives(), traffic, [](int life) {
    ros::param::set("paths/outside", life % 2 == 0 ? "free" : "blocked");
  });
}

}  // namespace
}  // namespace polygonal_perception::test

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_lifecycle");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}

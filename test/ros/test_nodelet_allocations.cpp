// What the node allocates for a frame: its messages, and nothing else.
#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <cstring>

#include "polygonal_perception/PolygonArray.h"
#include "ros/perception/frame_processor.hpp"
#include "ros/perception/message_conversions.hpp"
#include "support/allocation_counter.hpp"
#include "support/box_scene.hpp"

namespace polygonal_perception::test {
namespace {

sensor_msgs::PointCloud2Ptr boxCloud()
{
  BoxScene scene;
  scene.boxes = {{Eigen::Vector3d(1.8, -0.3, 0.0), Eigen::Vector3d(2.2, 0.3, 0.4)}};
  const std::vector<float> depth = scene.depth();
  const perception::PinholeRays rays = scene.rays();
  const perception::PointView points =
      perception::PointView::depth(depth.data(), sizeof(float) * scene.width, rays);
  auto cloud = boost::make_shared<sensor_msgs::PointCloud2>();
  cloud->header.frame_id = "camera_depth_optical_frame";
  cloud->height = scene.height;
  cloud->width = scene.width;
  sensor_msgs::PointCloud2Modifier(*cloud).setPointCloud2FieldsByString(1, "xyz");
  sensor_msgs::PointCloud2Iterator<float> at(*cloud, "x");
  for (std::uint32_t v = 0; v < scene.height; ++v) {
    for (std::uint32_t u = 0; u < scene.width; ++u, ++at) std::memcpy(&*at, points.point(u, v).data(), 12);
  }
  return cloud;
}

class NodeletAllocations : public testing::Test
{
protected:
  void SetUp() override
  {
    if (!AllocationCounter::available()) GTEST_SKIP() << "a sanitizer counts allocations itself";
    // The broadcast of the floor frame is a message too, which tf2 makes.
    parameters_.publish_tf = false;
    ros_perception::addOutputs(outputs_);
  }

  /// Allocations of the processor for the last of some frames.
  std::size_t ofAFrame(ros_perception::FrameProcessor& processor)
  {
    std::size_t count = 0;
    for (int k = 0; k < 10; ++k) {
      cloud_->header.stamp += ros::Duration(0.033);
      const ros_perception::InputFrame frame{cloud_, nullptr};
      const AllocationCounter counter;
      processor.process(frame, false);
      count = counter.count();
      ros::getGlobalCallbackQueue()->callAvailable();
    }
    return count;
  }

  ros::NodeHandle node_{"~"};
  ros_perception::PerceptionParameters parameters_;
  sensor_msgs::PointCloud2Ptr cloud_ = boxCloud();
  ros_perception::Outputs outputs_{node_, [] {}};
  ros_common::FrameStatistics statistics_ = ros_common::FrameStatistics::ofStages<perception::StageTimes>();
  ros_common::ThrottledLog log_{"test"};
};

TEST_F(NodeletAllocations, AreNoneWithoutReaders)
{
  ros_perception::FrameProcessor processor(parameters_, "camera_info", outputs_, statistics_, log_);
  EXPECT_EQ(ofAFrame(processor), 0U);
  EXPECT_EQ(processor.floor().status, perception::FloorStatus::kFound);
}

TEST_F(NodeletAllocations, AreThePolygonsWithAReaderOfThem)
{
  PolygonArrayConstPtr polygons;
  const boost::function<void(const PolygonArrayConstPtr&)> keep = [&](const PolygonArrayConstPtr& p) {
    polygons = p;
  };
  const ros::Subscriber reader = node_.subscribe<PolygonArray>("polygons", 5, keep);
  ros_perception::FrameProcessor processor(parameters_, "camera_info", outputs_, statistics_, log_);
  const std::size_t count = ofAFrame(processor);
  ASSERT_TRUE(polygons);
  ASSERT_EQ(polygons->polygons.size(), 1U);

  // The same message again, made and published without a node around it.
  const boost::function<void(const PolygonArrayConstPtr&)> ignore = [](const PolygonArrayConstPtr&) {};
  const ros::Publisher publisher = node_.advertise<PolygonArray>("control", 1);
  const ros::Subscriber control_reader = node_.subscribe<PolygonArray>("control", 5, ignore);
  std::size_t control = 0;
  for (int k = 0; k < 10; ++k) {
    const AllocationCounter counter;
    const auto message = boost::make_shared<PolygonArray>(*polygons);
    publisher.publish(message);
    control = counter.count();
    ros::getGlobalCallbackQueue()->callAvailable();
  }
  EXPECT_EQ(count, control);
}

}  // namespace
}  // namespace polygonal_perception::test

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "nodelet_allocations");
  const ros::NodeHandle keeps_ros_up;
  return RUN_ALL_TESTS();
}

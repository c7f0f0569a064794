// In one nodelet manager the memory that a camera's driver publishes is the memory that the pipeline reads. A
// frame that waits for its transforms shows it: it is published as an empty floor, gets its obstacle while it
// waits, and is answered with the obstacle's polygon. Whatever had copied or serialised it would have kept
// the empty floor.
#include <gtest/gtest.h>
#include <nodelet/loader.h>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/image_encodings.h>
#include <sensor_msgs/point_cloud2_iterator.h>
#include <tf2_msgs/TFMessage.h>

#include <cstring>
#include <string>
#include <vector>

#include "counting_publisher.hpp"
#include "polygonal_perception/FloorPlane.h"
#include "polygonal_perception/PolygonArray.h"
#include "support/box_scene.hpp"

namespace polygonal_perception::test {
namespace {

const char* const kFrame = "camera_depth_optical_frame";

void writeTo(sensor_msgs::PointCloud2& cloud, const BoxScene& scene)
{
  const std::vector<float> depth = scene.depth();
  const perception::PinholeRays rays = scene.rays();
  const perception::PointView points =
      perception::PointView::depth(depth.data(), sizeof(float) * scene.width, rays);
  sensor_msgs::PointCloud2Iterator<float> at(cloud, "x");
  for (std::uint32_t v = 0; v < scene.height; ++v) {
    for (std::uint32_t u = 0; u < scene.width; ++u, ++at) std::memcpy(&*at, points.point(u, v).data(), 12);
  }
}

void writeTo(sensor_msgs::Image& image, const BoxScene& scene)
{
  const std::vector<float> depth = scene.depth();
  std::memcpy(image.data.data(), depth.data(), image.data.size());
}

void shape(sensor_msgs::PointCloud2& cloud, const BoxScene& scene)
{
  cloud.height = scene.height;
  cloud.width = scene.width;
  sensor_msgs::PointCloud2Modifier(cloud).setPointCloud2FieldsByString(1, "xyz");
}

void shape(sensor_msgs::Image& image, const BoxScene& scene)
{
  image.height = scene.height;
  image.width = scene.width;
  image.encoding = sensor_msgs::image_encodings::TYPE_32FC1;
  image.step = image.width * sizeof(float);
  image.data.resize(std::size_t{image.height} * image.step);
}

void publishCalibration(const ros::Publisher& publisher, const BoxScene& scene, const ros::Time& stamp)
{
  sensor_msgs::CameraInfo info;
  info.header.stamp = stamp;
  info.header.frame_id = kFrame;
  info.width = scene.width;
  info.height = scene.height;
  const perception::PinholeRays rays = scene.rays();
  const double focal_length = 1.0 / (rays.column_slope[1] - rays.column_slope[0]);
  info.P = {focal_length,
            0.0,
            0.5 * (scene.width - 1.0),
            0.0,
            0.0,
            focal_length,
            0.5 * (scene.height - 1.0),
            0.0,
            0.0,
            0.0,
            1.0,
            0.0};
  publisher.publish(info);
}

/// The transform that the frame waits for.
tf2_msgs::TFMessage transformOf(const BoxScene& scene, const ros::Time& stamp)
{
  const Eigen::Isometry3d pose = scene.toFloorFrame();
  const Eigen::Quaterniond rotation(pose.rotation());
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = stamp;
  transform.header.frame_id = "odom";
  transform.child_frame_id = kFrame;
  transform.transform.translation.z = pose.translation().z();
  transform.transform.rotation.x = rotation.x();
  transform.transform.rotation.y = rotation.y();
  transform.transform.rotation.z = rotation.z();
  transform.transform.rotation.w = rotation.w();
  tf2_msgs::TFMessage message;
  message.transforms.push_back(transform);
  return message;
}

template <class Message>
void expectThatTheFrameItselfIsRead(const std::string& topic, const std::string& nodelet)
{
  CountingPublisher<Message> camera(topic);
  ros::NodeHandle node;
  const ros::Publisher calibration = node.advertise<sensor_msgs::CameraInfo>("depth/camera_info", 1, true);
  const ros::Publisher transforms = node.advertise<tf2_msgs::TFMessage>("/tf", 1);
  PolygonArrayConstPtr answer;
  const ros::Subscriber reader = node.subscribe<PolygonArray>(
      nodelet + "/polygons", 1, [&](const PolygonArrayConstPtr& polygons) { answer = polygons; });
  nodelet::Loader manager;
  ASSERT_TRUE(manager.load(nodelet, "polygonal_perception/PolygonalPerception", {}, {}));
  ASSERT_TRUE(waitFor([&] { return camera.readers() == 1 && transforms.getNumSubscribers() == 1; }))
      << camera.readers() << " readers of " << topic << ", " << transforms.getNumSubscribers() << " of /tf";

  BoxScene scene;
  const ros::Time stamp = ros::Time::now();
  const auto frame = boost::make_shared<Message>();
  frame->header.stamp = stamp;
  frame->header.frame_id = kFrame;
  shape(*frame, scene);
  writeTo(*frame, scene);
  publishCalibration(calibration, scene, stamp);
  camera.publish(frame);
  EXPECT_GT(frame.use_count(), 1) << "the frame is not held where it was published";

  scene.boxes = {{Eigen::Vector3d(1.8, -0.3, 0.0), Eigen::Vector3d(2.2, 0.3, 0.4)}};
  writeTo(*frame, scene);
  transforms.publish(transformOf(scene, stamp));
  ASSERT_TRUE(waitFor([&] { return answer != nullptr; })) << "no answer";
  EXPECT_EQ(answer->header.stamp, stamp);
  EXPECT_EQ(answer->floor_status, FloorPlane::FOUND);
  EXPECT_EQ(answer->polygons.size(), 1U) << "the obstacle that came after the publishing was not seen";
  EXPECT_EQ(camera.serialisations(), 0);
  EXPECT_TRUE(waitFor([&] { return frame.use_count() == 1; })) << "the answered frame is still held";
}

TEST(ZeroCopy, TheCloudThatIsPublishedIsTheOneThatIsRead)
{
  expectThatTheFrameItselfIsRead<sensor_msgs::PointCloud2>("/points", "/cloud_perception");
}

TEST(ZeroCopy, TheDepthImageThatIsPublishedIsTheOneThatIsRead)
{
  expectThatTheFrameItselfIsRead<sensor_msgs::Image>("/depth/image", "/depth_perception");
}

}  // namespace
}  // namespace polygonal_perception::test

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "zero_copy");
  const ros::NodeHandle keeps_ros_up;
  return RUN_ALL_TESTS();
}

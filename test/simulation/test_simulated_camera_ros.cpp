// What the simulated camera says on its topics: the image, the cloud, the transforms and the truth of a stamp
// agree.
#include <gtest/gtest.h>
#include <polygonal_perception/FloorPlane.h>
#include <polygonal_perception/PolygonArray.h>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_ros/transform_listener.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstring>
#include <map>

namespace polygonal_perception::test {
namespace {

/// All messages of a topic by their stamps.
template <class Message>
class Recorder
{
public:
  Recorder(ros::NodeHandle& node, const std::string& topic)
      : subscriber_(node.subscribe(topic, 100, &Recorder::remember, this))
  {
  }
  typename Message::ConstPtr at(const ros::Time& stamp) const
  {
    const auto found = messages_.find(stamp);
    return found == messages_.end() ? nullptr : found->second;
  }
  const std::map<ros::Time, typename Message::ConstPtr>& all() const { return messages_; }

private:
  void remember(const typename Message::ConstPtr& message) { messages_[message->header.stamp] = message; }

  std::map<ros::Time, typename Message::ConstPtr> messages_;
  ros::Subscriber subscriber_;
};

class SimulatedCameraTopics : public testing::Test
{
protected:
  /// A stamp for which every topic has spoken, and tf knows where the camera was.
  ros::Time waitForFrame()
  {
    const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(30.0);
    while (ros::ok() && ros::WallTime::now() < deadline) {
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.05));
      for (const auto& entry : raw_.all()) {
        const ros::Time& stamp = entry.first;
        if (rectified_.at(stamp) && info_.at(stamp) && points_.at(stamp) && floor_.at(stamp) &&
            obstacles_.at(stamp) && transforms_.canTransform("odom", "camera_depth_optical_frame", stamp)) {
          return stamp;
        }
      }
    }
    ADD_FAILURE() << "no common stamp; images " << raw_.all().size() << ", rectified "
                  << rectified_.all().size() << ", infos " << info_.all().size() << ", clouds "
                  << points_.all().size() << ", floors " << floor_.all().size() << ", obstacles "
                  << obstacles_.all().size();
    return {};
  }

  Eigen::Vector3f point(const sensor_msgs::PointCloud2& cloud, std::size_t i) const
  {
    Eigen::Vector3f p;
    std::memcpy(p.data(), &cloud.data[i * cloud.point_step], 3 * sizeof(float));
    return p;
  }

  ros::NodeHandle node_;
  tf2_ros::Buffer transforms_;
  tf2_ros::TransformListener listener_{transforms_};
  Recorder<sensor_msgs::Image> raw_{node_, "/camera/depth/image_raw"};
  Recorder<sensor_msgs::Image> rectified_{node_, "/camera/depth/image_rect"};
  Recorder<sensor_msgs::CameraInfo> info_{node_, "/camera/depth/camera_info"};
  Recorder<sensor_msgs::PointCloud2> points_{node_, "/camera/depth/points"};
  Recorder<FloorPlane> floor_{node_, "/simulated_camera/ground_truth/floor"};
  Recorder<PolygonArray> obstacles_{node_, "/simulated_camera/ground_truth/obstacles"};
};

TEST_F(SimulatedCameraTopics, ImagesAndCloudAreOneFrame)
{
  const ros::Time stamp = waitForFrame();
  ASSERT_FALSE(stamp.isZero());
  const sensor_msgs::Image& image = *raw_.at(stamp);
  const sensor_msgs::CameraInfo& info = *info_.at(stamp);
  const sensor_msgs::PointCloud2& cloud = *points_.at(stamp);
  EXPECT_EQ(image.encoding, "16UC1");
  EXPECT_EQ(image.header.frame_id, "camera_depth_optical_frame");
  EXPECT_EQ(info.header.frame_id, "camera_depth_optical_frame");
  EXPECT_EQ(cloud.header.frame_id, "camera_depth_optical_frame");
  ASSERT_EQ(image.width, 640U);
  ASSERT_EQ(image.height, 480U);
  ASSERT_EQ(info.width, 640U);
  ASSERT_EQ(cloud.width, 640U);
  ASSERT_EQ(cloud.height, 480U);
  EXPECT_EQ(cloud.point_step, 16U);
  EXPECT_FALSE(cloud.is_dense);
  EXPECT_EQ(rectified_.at(stamp)->data, image.data);

  std::size_t seen = 0;
  for (std::size_t i = 0; i < std::size_t{640} * 480; ++i) {
    std::uint16_t millimetres = 0;
    std::memcpy(&millimetres, &image.data[2 * i], sizeof millimetres);
    const Eigen::Vector3f p = point(cloud, i);
    if (millimetres == 0) {
      ASSERT_TRUE(std::isnan(p.z())) << "pixel " << i;
      continue;
    }
    ++seen;
    ASSERT_NEAR(p.z(), 0.001 * millimetres, 0.00051) << "pixel " << i;
    const std::size_t row = i / 640;
    ASSERT_NEAR(p.x(), p.z() * (static_cast<double>(i % 640) - info.K[2]) / info.K[0], 1e-5) << "pixel " << i;
    ASSERT_NEAR(p.y(), p.z() * (static_cast<double>(row) - info.K[5]) / info.K[4], 1e-5) << "pixel " << i;
  }
  EXPECT_GT(seen, 100000U);
}

TEST_F(SimulatedCameraTopics, TruthAgreesWithTheTransformsAndTheCloud)
{
  const ros::Time stamp = waitForFrame();
  ASSERT_FALSE(stamp.isZero());
  const geometry_msgs::Transform camera =
      transforms_.lookupTransform("odom", "camera_depth_optical_frame", stamp).transform;
  const Eigen::Quaterniond rotation(camera.rotation.w, camera.rotation.x, camera.rotation.y,
                                    camera.rotation.z);
  const Eigen::Vector3d up = rotation.inverse() * Eigen::Vector3d::UnitZ();
  const FloorPlane& floor = *floor_.at(stamp);
  EXPECT_EQ(floor.status, FloorPlane::FOUND);
  EXPECT_NEAR(floor.normal.x, up.x(), 1e-6);
  EXPECT_NEAR(floor.normal.y, up.y(), 1e-6);
  EXPECT_NEAR(floor.normal.z, up.z(), 1e-6);
  EXPECT_NEAR(floor.distance, camera.translation.z, 1e-6);

  const sensor_msgs::PointCloud2& cloud = *points_.at(stamp);
  std::size_t on_floor = 0;
  for (std::size_t i = 0; i < std::size_t{640} * 480; ++i) {
    // Mats are part of the floor and up to 5 mm thick.
    const double height = up.dot(point(cloud, i).cast<double>()) + camera.translation.z;
    on_floor += static_cast<std::size_t>(height > -0.001 && height < 0.006);
  }
  EXPECT_GT(floor.sample_count, 3000U);
  EXPECT_GE(on_floor, floor.sample_count);

  const PolygonArray& obstacles = *obstacles_.at(stamp);
  EXPECT_EQ(obstacles.header.frame_id, "odom");
  EXPECT_GT(obstacles.polygons.size(), 4U) << "four walls at least";
  for (const ObstaclePolygon& polygon : obstacles.polygons) EXPECT_GE(polygon.boundary.points.size(), 3U);
}

}  // namespace
}  // namespace polygonal_perception::test

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_simulated_camera");
  return RUN_ALL_TESTS();
}

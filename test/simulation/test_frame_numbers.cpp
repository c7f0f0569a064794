// The simulated camera numbers its frames for readers in its own process, too, where roscpp does not: by the
// gaps they know what they have missed.
#include <gtest/gtest.h>
#include <nodelet/loader.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

#include <cstdint>
#include <vector>

namespace polygonal_perception::test {
namespace {

constexpr std::size_t kFrames = 5;
using Numbers = std::vector<std::uint32_t>;

template <class Message>
ros::Subscriber read(ros::NodeHandle& handle, const std::string& topic, Numbers& numbers)
{
  return handle.subscribe<Message>(topic, 1000, [&numbers](const typename Message::ConstPtr& message) {
    numbers.push_back(message->header.seq);
  });
}

void expectConsecutive(const Numbers& numbers)
{
  EXPECT_GT(numbers.front(), 0U);
  for (std::size_t k = 1; k < numbers.size(); ++k) EXPECT_EQ(numbers[k], numbers[0] + k) << "message " << k;
}

TEST(FrameNumbers, AreConsecutiveInTheCamerasOwnProcess)
{
  ros::NodeHandle handle;
  Numbers images;
  Numbers clouds;
  const ros::Subscriber image_reader = read<sensor_msgs::Image>(handle, "camera/depth/image_rect", images);
  const ros::Subscriber cloud_reader = read<sensor_msgs::PointCloud2>(handle, "camera/depth/points", clouds);
  nodelet::Loader manager;
  ASSERT_TRUE(manager.load("/simulated_camera", "polygonal_perception/SimulatedCamera", {}, {}));
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(30.0);
  while (images.size() < kFrames || clouds.size() < kFrames) {
    ASSERT_LT(ros::WallTime::now(), end) << images.size() << " images, " << clouds.size() << " clouds";
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.02));
  }
  expectConsecutive(images);
  expectConsecutive(clouds);
}

}  // namespace
}  // namespace polygonal_perception::test

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "frame_numbers");
  const ros::NodeHandle keeps_ros_up;
  return RUN_ALL_TESTS();
}

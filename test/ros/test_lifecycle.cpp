// A node that is taken down while frames, readers and calls arrive from all sides, as when a nodelet is
// unloaded.
#include <dynamic_reconfigure/Reconfigure.h>
#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <thread>

#include "clouds.hpp"
#include "polygonal_perception/PolygonArray.h"
#include "polygonal_perception/ros/perception/perception_node.hpp"

namespace polygonal_perception::test {
namespace {

constexpr int kLives = 60;  // unless ~lives says otherwise

/// A thread that serves a queue, one callback at a time, while another one takes the node down: as a nodelet
/// manager does.
class Worker
{
public:
  Worker() : spinner_(1, &queue_) { spinner_.start(); }
  ~Worker() { spinner_.stop(); }
  ros::CallbackQueue& queue() { return queue_; }

private:
  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_;
};

TEST(Lifecycle, EndsCleanlyWhileFramesReadersAndCallsArrive)
{
  ros::NodeHandle handle;
  ros::Publisher clouds = handle.advertise<sensor_msgs::PointCloud2>("points", 1);
  std::atomic<bool> running{true};
  std::atomic<int> answers{0};

  std::thread camera([&] {
    ros::WallRate rate(500.0);
    while (running) {
      clouds.publish(floorCloud(ros::Time::now()));
      rate.sleep();
    }
  });
  std::thread reader([&] {
    ros::NodeHandle own;
    ros::CallbackQueue queue;
    own.setCallbackQueue(&queue);
    while (running) {
      const boost::function<void(const PolygonArrayConstPtr&)> count =
          [&answers](const PolygonArrayConstPtr&) { ++answers; };
      const ros::Subscriber polygons = own.subscribe<PolygonArray>("perception/polygons", 5, count);
      for (int i = 0; running && i < 20; ++i) queue.callAvailable(ros::WallDuration(0.002));
    }
  });
  std::thread caller([&] {
    while (running) {
      std_srvs::Trigger reset;
      ros::service::call("perception/reset", reset);
      dynamic_reconfigure::Reconfigure set;
      ros::service::call("perception/set_parameters", set);
    }
  });

  Worker worker;
  handle.setCallbackQueue(&worker.queue());
  ros::NodeHandle private_handle(handle, "perception");
  private_handle.setCallbackQueue(&worker.queue());
  const int lives = ros::param::param("~lives", kLives);
  for (int life = 0; life < lives; ++life) {
    private_handle.setParam("lazy", life % 2 == 0);
    const ros_perception::PerceptionNode perception(handle, private_handle);
    const int before = answers;
    if (life % 10 != 9) continue;
    // Every tenth life lasts until it has answered, the others end at once.
    const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(10.0);
    while (answers == before && ros::WallTime::now() < deadline) std::this_thread::yield();
    EXPECT_GT(answers, before) << "no answer in life " << life;
  }
  running = false;
  camera.join();
  reader.join();
  caller.join();
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

// How long it takes in one nodelet manager from the publishing of a frame to the arrival of its polygons, and
// what share of a core the whole process takes at a camera's rate. See scripts/latency.

#include <nodelet/loader.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/image_encodings.h>
#include <sensor_msgs/point_cloud2_iterator.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "camera_frames.hpp"
#include "polygonal_perception/FloorPlane.h"
#include "polygonal_perception/PolygonArray.h"

namespace polygonal_perception::benchmarks {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kRate = 30.0;  // [Hz]
constexpr std::uint32_t kFrames = 4;
const char* const kFrameId = "camera_depth_optical_frame";
const char* const kImage = "/camera/depth/image_rect";
const char* const kInfo = "/camera/depth/camera_info";
const char* const kPoints = "/camera/depth/points";
const char* const kPerception = "/polygonal_perception";

double seconds(Clock::duration duration)
{
  return std::chrono::duration<double>(duration).count();
}

/// [s] of all the process's threads.
double processorTime()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto of = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return of(usage.ru_utime) + of(usage.ru_stime);
}

/// Plays a drive through an office as a camera's driver does. What it costs is a message a frame: they are
/// made before.
class Camera
{
public:
  Camera()
  {
    for (const auto& frame : drive(Surroundings::kOffice, 640, 480, kFrames)) {
      const perception::PointView depth = frame->view(Input::kDepthMillimetres);
      auto image = boost::make_shared<sensor_msgs::Image>();
      image->header.frame_id = kFrameId;
      image->width = depth.width();
      image->height = depth.height();
      image->encoding = sensor_msgs::image_encodings::TYPE_16UC1;
      image->step = depth.width() * sizeof(std::uint16_t);
      image->data.assign(depth.row(0), depth.row(0) + std::size_t{image->step} * image->height);
      images_.push_back(image);

      auto cloud = boost::make_shared<sensor_msgs::PointCloud2>();
      cloud->header.frame_id = kFrameId;
      cloud->width = depth.width();
      cloud->height = depth.height();
      sensor_msgs::PointCloud2Modifier(*cloud).setPointCloud2FieldsByString(1, "xyz");
      std::memcpy(cloud->data.data(), frame->cloud16().data(), cloud->data.size());
      clouds_.push_back(cloud);
    }
    const simulation::PinholeCamera camera;
    info_.header.frame_id = kFrameId;
    info_.width = camera.width;
    info_.height = camera.height;
    info_.K = {camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0};
    info_.P = {camera.fx, 0.0, camera.cx, 0.0, 0.0, camera.fy, camera.cy, 0.0, 0.0, 0.0, 1.0, 0.0};
  }

  void publish(const ros::Time& stamp)
  {
    const std::size_t k = next_++ % kFrames;
    if (images_publisher_.getNumSubscribers() > 0) {
      // Nobody holds the message of four frames ago any more.
      images_[k]->header.stamp = stamp;
      auto info = boost::make_shared<sensor_msgs::CameraInfo>(info_);
      info->header.stamp = stamp;
      images_publisher_.publish(images_[k]);
      infos_publisher_.publish(info);
    }
    if (send_clouds_) {
      clouds_[k]->header.stamp = stamp;
      clouds_publisher_.publish(clouds_[k]);
    }
  }

  void sendClouds(bool send)
  {
    send_clouds_ = send;
    if (send) {
      clouds_publisher_ = node_.advertise<sensor_msgs::PointCloud2>(kPoints, 1);
    } else {
      clouds_publisher_.shutdown();
    }
  }

private:
  ros::NodeHandle node_;
  ros::Publisher images_publisher_ = node_.advertise<sensor_msgs::Image>(kImage, 1);
  ros::Publisher infos_publisher_ = node_.advertise<sensor_msgs::CameraInfo>(kInfo, 1);
  ros::Publisher clouds_publisher_;
  sensor_msgs::CameraInfo info_;
  std::vector<sensor_msgs::ImagePtr> images_;
  std::vector<sensor_msgs::PointCloud2Ptr> clouds_;
  std::size_t next_ = 0;
  bool send_clouds_ = false;
};

/// Waits for polygons in a thread of its own, as the nodelet that plans with them would.
class Reader
{
public:
  Reader()
  {
    node_.setCallbackQueue(&queue_);
    const boost::function<void(const PolygonArrayConstPtr&)> arrived =
        [this](const PolygonArrayConstPtr& polygons) {
          const auto now = Clock::now();
          const std::lock_guard<std::mutex> lock(mutex_);
          const auto sent = sent_.find(polygons->header.stamp);
          if (sent == sent_.end() || polygons->floor_status != FloorPlane::FOUND) return;
          delays_.push_back(seconds(now - sent->second));
        };
    subscriber_ = node_.subscribe<PolygonArray>(std::string(kPerception) + "/polygons", 5, arrived);
    spinner_.start();
  }

  void sent(const ros::Time& stamp)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    sent_[stamp] = Clock::now();
  }

  /// [s] in ascending order.
  std::vector<double> delays()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::sort(delays_.begin(), delays_.end());
    return delays_;
  }

private:
  std::mutex mutex_;
  std::map<ros::Time, Clock::time_point> sent_;
  std::vector<double> delays_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::Subscriber subscriber_;
  ros::AsyncSpinner spinner_{1, &queue_};
};

/// Plays for a while and prints what came of it.
void play(const char* title, Camera& camera, double duration)
{
  Reader reader;
  constexpr double kWarmUp = 2.0;  // [s]
  const auto period = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1.0 / kRate));
  auto next = Clock::now();
  const auto publishUntil = [&](Clock::time_point end, bool measured) {
    int count = 0;
    for (; ros::ok() && next < end; next += period, ++count) {
      std::this_thread::sleep_until(next);
      const ros::Time stamp = ros::Time::now();
      if (measured) reader.sent(stamp);
      camera.publish(stamp);
    }
    return count;
  };
  publishUntil(next + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(kWarmUp)),
               false);
  const auto start = Clock::now();
  const double busy = processorTime();
  const int count = publishUntil(
      next + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(duration)), true);
  std::this_thread::sleep_until(next);
  const double share = (processorTime() - busy) / seconds(Clock::now() - start);

  const std::vector<double> delays = reader.delays();
  std::printf("%-44s", title);
  if (delays.empty()) {
    std::printf(" %27s", "");
  } else {
    std::printf(" median %5.2f ms, 99 %% %5.2f ms,", 1e3 * delays[delays.size() / 2],
                1e3 * delays[delays.size() * 99 / 100]);
  }
  std::printf(" %4.1f %% of a core, %zu of %d frames answered\n", 100.0 * share, delays.size(), count);
  std::fflush(stdout);
}

bool loadPerception(nodelet::Loader& manager, const std::string& input)
{
  ros::param::set(std::string(kPerception) + "/input", input);
  return manager.load(kPerception, "polygonal_perception/PolygonalPerception",
                      {{"/points", kPoints}, {"/depth/image", kImage}, {"/depth/camera_info", kInfo}}, {});
}

int measure(double duration)
{
  Camera camera;
  play("nobody", camera, duration);
  {
    nodelet::Loader manager;
    if (!loadPerception(manager, "depth")) return 1;
    play("depth image", camera, duration);
  }
  {
    nodelet::Loader manager;
    if (!loadPerception(manager, "cloud")) return 1;
    camera.sendClouds(true);
    play("cloud", camera, duration);
    camera.sendClouds(false);
  }
  nodelet::Loader manager;
  if (!loadPerception(manager, "cloud")) return 1;
  if (manager.load("/point_cloud_xyz", "depth_image_proc/point_cloud_xyz",
                   {{"/image_rect", kImage}, {"/camera_info", kInfo}, {"/points", kPoints}}, {})) {
    play("depth image, depth_image_proc makes the cloud", camera, duration);
  } else {
    std::printf("depth_image_proc is not installed\n");
  }
  return 0;
}

}  // namespace
}  // namespace polygonal_perception::benchmarks

int main(int argc, char** argv)
{
  ros::init(argc, argv, "latency");
  const double duration = argc > 1 ? std::atof(argv[1]) : 10.0;
  const ros::NodeHandle keeps_ros_up;
  return polygonal_perception::benchmarks::measure(duration);
}

// Plays depth frames to a node in another process at a steady rate for a long time, and says whether each was
// answered once, how long that took, and whether the node's memory grew. See scripts/soak.
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/image_encodings.h>

#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

#include "camera_frames.hpp"
#include "soak_record.hpp"

namespace polygonal_perception::benchmarks {
namespace {

constexpr std::uint32_t kFrames = 4;
const char* const kFrameId = "camera_depth_optical_frame";
const char* const kPerception = "/polygonal_perception";

std::vector<sensor_msgs::Image> makeImages()
{
  std::vector<sensor_msgs::Image> images;
  for (const auto& frame : drive(Surroundings::kOffice, 640, 480, kFrames)) {
    const perception::PointView depth = frame->view(Input::kDepthMillimetres);
    sensor_msgs::Image& image = images.emplace_back();
    image.header.frame_id = kFrameId;
    image.width = depth.width();
    image.height = depth.height();
    image.encoding = sensor_msgs::image_encodings::TYPE_16UC1;
    image.step = depth.width() * sizeof(std::uint16_t);
    image.data.assign(depth.row(0), depth.row(0) + std::size_t{image.step} * image.height);
  }
  return images;
}

sensor_msgs::CameraInfo makeInfo()
{
  const simulation::PinholeCamera camera;
  sensor_msgs::CameraInfo info;
  info.header.frame_id = kFrameId;
  info.width = camera.width;
  info.height = camera.height;
  info.P = {camera.fx, 0.0, camera.cx, 0.0, 0.0, camera.fy, camera.cy, 0.0, 0.0, 0.0, 1.0, 0.0};
  return info;
}

bool soak(int process, double duration, double rate)
{
  ros::NodeHandle node;
  const ros::Publisher images = node.advertise<sensor_msgs::Image>("/camera/depth/image_rect", 1);
  const ros::Publisher infos = node.advertise<sensor_msgs::CameraInfo>("/camera/depth/camera_info", 1);
  std::vector<sensor_msgs::Image> frames = makeImages();
  sensor_msgs::CameraInfo info = makeInfo();
  Reader reader(kPerception);
  ros::AsyncSpinner spinner(1);
  spinner.start();
  while (ros::ok() &&
         !(reader.connected() && images.getNumSubscribers() > 0 && infos.getNumSubscribers() > 0)) {
    ros::WallDuration(0.05).sleep();
  }

  MemoryRecord memory(process);
  const auto start = Clock::now();
  const auto period = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1.0 / rate));
  double next_look = 0.0;
  auto next = start;
  for (std::size_t k = 0; ros::ok() && seconds(next - start) < duration; ++k, next += period) {
    std::this_thread::sleep_until(next);
    info.header.stamp = frames[k % kFrames].header.stamp = ros::Time::now();
    reader.sent(info.header.stamp);
    infos.publish(info);
    images.publish(frames[k % kFrames]);
    if (seconds(next - start) < next_look) continue;
    memory.look(seconds(next - start));
    next_look += kMemoryPeriod;
  }
  // The last answers and the report on them.
  ros::WallDuration(3.0).sleep();
  memory.look(seconds(Clock::now() - start));
  const bool sound = reader.report();
  print(memory, duration);
  return sound;
}

}  // namespace
}  // namespace polygonal_perception::benchmarks

int main(int argc, char** argv)
{
  ros::init(argc, argv, "soak");
  if (argc != 4) {
    std::fprintf(stderr, "usage: soak PROCESS SECONDS RATE\n");
    return 2;
  }
  return polygonal_perception::benchmarks::soak(std::atoi(argv[1]), std::atof(argv[2]), std::atof(argv[3]))
             ? 0
             : 1;
}

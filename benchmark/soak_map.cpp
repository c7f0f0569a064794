// Plays the observed cells of a robot that drives round and round to the map's node in another process, for a long time, and
// says whether each was answered once, how long that took, and whether the node's memory grew. See scripts/soak.
#include <polygonal_perception/FloorPlane.h>
#include <polygonal_perception/ObservedCells.h>
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

#include "reference/observed_drive.hpp"
#include "soak_record.hpp"

namespace polygonal_perception::benchmarks {
namespace {

constexpr double kRobotRate = 30.0;  // [Hz] of the frames, as the robot's time goes

std::vector<ObservedCells> makeMessages(const std::vector<reference::ObservedFrame>& drive)
{
  std::vector<ObservedCells> messages;
  for (const reference::ObservedFrame& frame : drive) {
    ObservedCells& message = messages.emplace_back();
    message.header.frame_id = "odom";
    message.floor_status = FloorPlane::FOUND;
    message.info.resolution = static_cast<float>(frame.geometry.resolution);
    message.info.width = static_cast<std::uint32_t>(frame.geometry.cells_x);
    message.info.height = static_cast<std::uint32_t>(frame.geometry.cells_y);
    const Eigen::Vector2d corner =
        frame.pose * Eigen::Vector2d(frame.geometry.origin_x, frame.geometry.origin_y);
    const double yaw = Eigen::Rotation2Dd(frame.pose.linear()).angle();
    message.info.origin.position.x = corner.x();
    message.info.origin.position.y = corner.y();
    message.info.origin.orientation.z = std::sin(yaw / 2.0);
    message.info.origin.orientation.w = std::cos(yaw / 2.0);
    message.slab_height = 0.2F;
    message.hit = frame.cells.hit;
    message.free = frame.cells.free;
    message.floor = frame.cells.floor;
  }
  return messages;
}

tf2_msgs::TFMessage placeOf(const reference::ObservedFrame& frame, const ros::Time& stamp)
{
  tf2_msgs::TFMessage message;
  message.transforms.resize(1);
  geometry_msgs::TransformStamped& transform = message.transforms[0];
  transform.header.stamp = stamp;
  transform.header.frame_id = "odom";
  transform.child_frame_id = "base_link";
  transform.transform.translation.x = frame.robot.x();
  transform.transform.translation.y = frame.robot.y();
  transform.transform.rotation.w = 1.0;
  return message;
}

/// @param duration  [s] of the robot's time
/// @param rate      [Hz] 0: each frame as soon as the one before it is answered
bool soak(int process, double duration, double rate)
{
  ros::NodeHandle node;
  const ros::Publisher cells = node.advertise<ObservedCells>("/observed_cells", 1);
  const ros::Publisher places = node.advertise<tf2_msgs::TFMessage>("/tf", 10);
  const std::vector<reference::ObservedFrame> drive = reference::observedDrive();
  std::vector<ObservedCells> messages = makeMessages(drive);
  Reader reader("/polygon_map");
  ros::AsyncSpinner spinner(1);
  spinner.start();
  while (ros::ok() &&
         !(reader.connected() && cells.getNumSubscribers() > 0 && places.getNumSubscribers() > 0))
    ros::WallDuration(0.05).sleep();

  MemoryRecord memory(process);
  const ros::Time first = ros::Time::now();
  const auto start = Clock::now();
  const double frame_rate = rate > 0.0 ? rate : kRobotRate;
  const auto stampOf = [&](std::size_t k) {
    return first + ros::Duration(static_cast<double>(k) / frame_rate);
  };
  const auto frames = static_cast<std::size_t>(duration * frame_rate);
  double next_look = 0.0;
  places.publish(placeOf(drive[0], stampOf(0)));
  for (std::size_t k = 0; ros::ok() && k < frames; ++k) {
    const double time = static_cast<double>(k) / frame_rate;
    if (rate > 0.0)
      std::this_thread::sleep_until(
          start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(time)));
    // Odometry is known before the frame is: what is measured is the map, not how long it waits for tf.
    places.publish(placeOf(drive[(k + 1) % drive.size()], stampOf(k + 1)));
    ObservedCells& message = messages[k % messages.size()];
    message.header.stamp = stampOf(k);
    reader.sent(message.header.stamp);
    cells.publish(message);
    if (rate <= 0.0 && !reader.waitFor(message.header.stamp)) {
      std::printf("no answer to frame %zu\n", k);
      return false;
    }
    if (time < next_look) continue;
    memory.look(time);
    next_look += kMemoryPeriod;
  }
  const double took = seconds(Clock::now() - start);
  std::printf("%.0f s of the robot's time in %.0f s, %.0f frames a second\n", duration, took,
              static_cast<double>(frames) / took);
  // The last answers and the report on them.
  ros::WallDuration(3.0).sleep();
  memory.look(duration);
  const bool sound = reader.report();
  print(memory, duration);
  return sound;
}

}  // namespace
}  // namespace polygonal_perception::benchmarks

int main(int argc, char** argv)
{
  ros::init(argc, argv, "soak_map");
  if (argc != 4) {
    std::fprintf(stderr, "usage: soak_map PROCESS SECONDS RATE\n");
    return 2;
  }
  return polygonal_perception::benchmarks::soak(std::atoi(argv[1]), std::atof(argv[2]), std::atof(argv[3]))
             ? 0
             : 1;
}
